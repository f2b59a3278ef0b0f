#include "core/numerics/polar.h"

#include <algorithm>

#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// Number of iterations that suffices for any condition: each halves the exponent of the largest
/// ratio of two stretches, and the last ones double the number of correct bits.
constexpr int most_iterations = 64;

Affine scaled(const Affine& m, double factor) {
    return {factor * m.x, factor * m.y, factor * m.z};
}

Affine transposed_inverse(const Affine& m) {
    const Affine cofactors{m.y.cross(m.z), m.z.cross(m.x), m.x.cross(m.y)};
    return scaled(cofactors, 1 / m.determinant());
}

Affine transposed_times(const Affine& a, const Affine& b) {
    const auto column = [&](const Vec3& v) { return Vec3(a.x.dot(v), a.y.dot(v), a.z.dot(v)); };
    return {column(b.x), column(b.y), column(b.z)};
}

}  // namespace

/// Uses Newton's iteration: the mean of a matrix and its transposed inverse.
PolarParts polar_parts(const Affine& map) {
    const double largest = std::max({max_abs(map.x), max_abs(map.y), max_abs(map.z)});
    Affine r = scaled(map, power_of_two_reciprocal(largest));
    for (int i = 0; i < most_iterations; ++i) {
        const Affine other = transposed_inverse(r);
        const Affine next = {(r.x + other.x) / 2, (r.y + other.y) / 2, (r.z + other.z) / 2};
        const double change =
            std::max({max_abs(next.x - r.x), max_abs(next.y - r.y), max_abs(next.z - r.z)});
        r = next;
        if (!(change > 8 * unit_roundoff)) break;
    }
    if (r.determinant() < 0) r = scaled(r, -1);
    return {r, transposed_times(r, map)};
}

}  // namespace etalon
