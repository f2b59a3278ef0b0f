#include "core/numerics/exact.h"

#include <tuple>

namespace etalon {
namespace {

using Difference = Expansion<2>;

Difference difference(double a, double b) {
    return Difference(two_difference(a, b));
}

bool precedes(const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b) {
    // Products of what is not finite could leave no terms at all, and so a zero.
    for (const Vec3& v : {o, d, a, b}) {
        if (!is_finite(v)) return nan_value;
    }
    const double plain = d.dot((a - o).cross(b - o));
    if (!std::isfinite(plain)) return plain;
    // The estimate's last bit depends on the order of the terms: take one order for both.
    if (precedes(b, a)) return -exact_edge_volume(o, d, b, a);
    const Difference px = difference(a.x, o.x), py = difference(a.y, o.y),
                     pz = difference(a.z, o.z);
    const Difference qx = difference(b.x, o.x), qy = difference(b.y, o.y),
                     qz = difference(b.z, o.z);
    const auto volume = Expansion<1>(d.x) * (py * qz - pz * qy) +
                        Expansion<1>(d.y) * (pz * qx - px * qz) +
                        Expansion<1>(d.z) * (px * qy - py * qx);
    return volume.estimate();
}

double exact_shear(double x, double a, double b, double y, double c, double e) {
    const double plain = x * (a - b) - y * (c - e);
    if (!std::isfinite(plain)) return plain;
    const auto shear = Expansion<1>(x) * difference(a, b) - Expansion<1>(y) * difference(c, e);
    return shear.estimate();
}

}  // namespace etalon
