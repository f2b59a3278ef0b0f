#include "core/numerics/exact.h"

#include <tuple>

namespace etalon {
namespace {

using Difference = Expansion<2>;

Difference difference(double a, double b) {
    return Difference(two_difference(a, b));
}

using Differences = std::array<Difference, 3>;

Differences differences(const Vec3& a, const Vec3& b) {
    return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

/// d . (p x q)
template <std::size_t N>
double triple_product(const std::array<Expansion<N>, 3>& d, const Differences& p,
                      const Differences& q) {
    const auto volume = d[0] * (p[1] * q[2] - p[2] * q[1]) + d[1] * (p[2] * q[0] - p[0] * q[2]) +
                        d[2] * (p[0] * q[1] - p[1] * q[0]);
    return volume.estimate();
}

std::array<Expansion<1>, 3> exactly(const Vec3& v) {
    return {Expansion<1>(v.x), Expansion<1>(v.y), Expansion<1>(v.z)};
}

bool precedes(const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b) {
    const double plain = d.dot((a - o).cross(b - o));
    if (!std::isfinite(plain)) return plain;  // a sum of no terms would hide a NaN
    // The estimate's last bit depends on the order of the terms: take one order for both.
    if (precedes(b, a)) return -exact_edge_volume(o, d, b, a);
    return triple_product(exactly(d), differences(a, o), differences(b, o));
}

double exact_volume(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double plain = (a - o).dot((b - o).cross(c - o));
    if (!std::isfinite(plain)) return plain;
    return triple_product(differences(a, o), differences(b, o), differences(c, o));
}

double exact_dot(const Vec3& n, const Vec3& d) {
    if (!std::isfinite(n.dot(d))) return n.dot(d);
    const auto product = [](double x, double y) { return Expansion<2>(two_product(x, y)); };
    return (product(n.x, d.x) + product(n.y, d.y) + product(n.z, d.z)).estimate();
}

double exact_dot(const Vec3& n, const Vec3& p, const Vec3& o) {
    if (!std::isfinite(n.dot(p - o))) return n.dot(p - o);
    const auto [x, y, z] = differences(p, o);
    return (Expansion<1>(n.x) * x + Expansion<1>(n.y) * y + Expansion<1>(n.z) * z).estimate();
}

double exact_shear(double x, double a, double b, double y, double c, double e) {
    const double plain = x * (a - b) - y * (c - e);
    if (!std::isfinite(plain)) return plain;
    const auto shear = Expansion<1>(x) * difference(a, b) - Expansion<1>(y) * difference(c, e);
    return shear.estimate();
}

}  // namespace etalon
