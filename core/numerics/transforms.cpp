#include "core/numerics/transforms.h"

#include <cmath>
#include <numbers>

#include "core/numerics/rounding.h"

namespace etalon {
namespace {

struct Turn {
    double sine, cosine;
};

/// Returns sine and cosine. The angle left after whole quarters is at most an eighth of a turn, and
/// exact.
Turn turn_of(double degrees) {
    int quarters = 0;
    const double rest = std::remquo(degrees, 90.0, &quarters) * (std::numbers::pi / 180);
    const double s = std::sin(rest), c = std::cos(rest);
    switch (quarters & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

/// Returns the map with each column scaled by the power of two that puts its largest number in [1,
/// 2).
Affine with_scaled_columns(const Affine& m) {
    return {to_unit_magnitude(m.x), to_unit_magnitude(m.y), to_unit_magnitude(m.z)};
}

}  // namespace

Affine translation(const Vec3& offset) {
    Affine m;
    m.origin = offset;
    return m;
}

Affine scaling(const Vec3& factors) {
    return {{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}};
}

/// Uses Rodrigues' formula, column by column.
Affine rotation(double degrees, const Vec3& axis) {
    const auto [s, c] = turn_of(degrees);
    const Vec3 n = unit_vector(axis);
    const auto image = [&, s = s, c = c](const Vec3& v) {
        return c * v + s * n.cross(v) + (1 - c) * n.dot(v) * n;
    };
    return {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1})};
}

Affine about_axis(const Vec3& origin, const Vec3& axis) {
    Affine m = translation(origin);
    m.z = unit_vector(axis);
    orthonormal_basis(m.z, m.x, m.y);
    return m;
}

bool is_singular(const Affine& map) {
    const Affine m = with_scaled_columns(map);
    double sum = 0, magnitude = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double plus = m.x[i] * m.y[j] * m.z[k], minus = m.x[i] * m.y[k] * m.z[j];
        sum += plus - minus;
        magnitude += std::abs(plus) + std::abs(minus);
    }
    return !(std::abs(sum) > 32 * unit_roundoff * magnitude);
}

bool mirrors(const Affine& map) {
    return with_scaled_columns(map).determinant() < 0;
}

/// Computes the cofactors of the columns, which are scaled so that no product overflows. What a
/// cofactor then lacks is the scale of its own column.
NormalMap::NormalMap(const Affine& map) {
    const Affine m = with_scaled_columns(map);
    const double side = mirrors(map) ? -1 : 1;
    const auto cofactor = [&](const Vec3& own, const Vec3& a, const Vec3& b) {
        return side * power_of_two_reciprocal(max_abs(own)) * a.cross(b);
    };
    x_ = cofactor(map.x, m.y, m.z);
    y_ = cofactor(map.y, m.z, m.x);
    z_ = cofactor(map.z, m.x, m.y);
}

}  // namespace etalon
