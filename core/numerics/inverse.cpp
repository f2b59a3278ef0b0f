#include "core/numerics/inverse.h"

#include "core/numerics/dyadic_vec.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

double quotient(const Dyadic& a, const Dyadic& b) {
    return a.sign() * b.sign() * static_cast<double>(a.magnitude() / b.magnitude());
}

double length_above(const Vec3& v) {
    return (1 + 4 * unit_roundoff) * std::hypot(v.x, v.y, v.z);
}

}  // namespace

/// By Cramer's rule.
LinearInverse::LinearInverse(const Affine& map) {
    if (!is_finite(map)) return;
    const DyadicVec a = exactly(map.x), b = exactly(map.y), c = exactly(map.z);
    const DyadicVec bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Dyadic determinant = dot(a, bc);
    if (determinant.sign() == 0) return;
    const auto row = [&](const DyadicVec& minors) {
        return Vec3(quotient(minors[0], determinant), quotient(minors[1], determinant),
                    quotient(minors[2], determinant));
    };
    x = row(bc);
    y = row(ca);
    z = row(ab);
    lengths = {length_above(x), length_above(y), length_above(z)};
    exists = true;
}

}  // namespace etalon
