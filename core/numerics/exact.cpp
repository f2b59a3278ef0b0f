#include "core/numerics/exact.h"

#include <tuple>

namespace etalon {
namespace {

using Difference = Expansion<2>;
using Vec3TwoTerm = std::array<TwoTerm, 3>;

Difference difference(double a, double b) {
    return Difference(two_difference(a, b));
}

Vec3TwoTerm difference(const Vec3& a, const Vec3& b) {
    return {two_difference(a.x, b.x), two_difference(a.y, b.y), two_difference(a.z, b.z)};
}

Vec3TwoTerm exactly(const Vec3& v) {
    return {TwoTerm{v.x, 0}, TwoTerm{v.y, 0}, TwoTerm{v.z, 0}};
}

/// Double-double arithmetic (Dekker 1971): sums and products to 2^-102 of their operands.
TwoTerm operator+(const TwoTerm& a, const TwoTerm& b) {
    const TwoTerm s = two_sum(a.value, b.value);
    return two_sum(s.value, s.error + (a.error + b.error));
}
TwoTerm operator*(const TwoTerm& a, const TwoTerm& b) {
    const TwoTerm p = two_product(a.value, b.value);
    return two_sum(p.value, p.error + (a.value * b.error + a.error * b.value));
}
TwoTerm operator-(const TwoTerm& a) {
    return {-a.value, -a.error};
}

/// d . (p x q), exactly.
double exact_triple_product(const Vec3TwoTerm& d, const Vec3TwoTerm& p, const Vec3TwoTerm& q) {
    const auto minor = [&](int i, int j) {
        const Difference pi(p[i]), pj(p[j]), qi(q[i]), qj(q[j]);
        return pi * qj - pj * qi;
    };
    const auto volume = Difference(d[0]) * minor(1, 2) + Difference(d[1]) * minor(2, 0) +
                        Difference(d[2]) * minor(0, 1);
    return volume.estimate();
}

/// The same by double-double, where that is good to 2^-38 of itself: its error is less than 2^-98
/// of its terms.
double triple_product(const Vec3TwoTerm& d, const Vec3TwoTerm& p, const Vec3TwoTerm& q) {
    TwoTerm volume{0, 0};
    double terms = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const TwoTerm left = p[i] * q[j], right = p[j] * q[i];
        volume = volume + d[k] * (left + -right);
        terms += std::abs(d[k].value) * (std::abs(left.value) + std::abs(right.value));
    }
    const bool in_range = terms > 0x1p-800;  // no product's error underflows
    if (in_range && std::abs(volume.value) > 0x1p-60 * terms) return volume.value;
    return exact_triple_product(d, p, q);
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
    return triple_product(exactly(d), difference(a, o), difference(b, o));
}

double exact_volume(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double plain = (a - o).dot((b - o).cross(c - o));
    if (!std::isfinite(plain)) return plain;
    return triple_product(difference(a, o), difference(b, o), difference(c, o));
}

double exact_dot(const Vec3& n, const Vec3& d) {
    return exact_dot(n, d, Vec3(0));
}

double exact_dot(const Vec3& n, const Vec3& p, const Vec3& o) {
    const double plain = n.dot(p - o);
    if (!std::isfinite(plain)) return plain;
    const Vec3TwoTerm d = difference(p, o);
    const std::array<TwoTerm, 3> term = {d[0] * TwoTerm{n.x, 0}, d[1] * TwoTerm{n.y, 0},
                                         d[2] * TwoTerm{n.z, 0}};
    const double sum = (term[0] + (term[1] + term[2])).value;
    const double terms =
        std::abs(term[0].value) + std::abs(term[1].value) + std::abs(term[2].value);
    if (terms > 0x1p-800 && std::abs(sum) > 0x1p-45 * terms) return sum;
    const auto exact = [](double x, const TwoTerm& y) { return Expansion<1>(x) * Difference(y); };
    return (exact(n.x, d[0]) + exact(n.y, d[1]) + exact(n.z, d[2])).estimate();
}

double exact_shear(double x, double a, double b, double y, double c, double e) {
    const double plain = x * (a - b) - y * (c - e);
    if (!std::isfinite(plain)) return plain;
    const auto shear = Expansion<1>(x) * difference(a, b) - Expansion<1>(y) * difference(c, e);
    return shear.estimate();
}

}  // namespace etalon
