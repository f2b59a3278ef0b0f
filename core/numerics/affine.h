#pragma once

#include <optional>

#include "core/numerics/vec.h"

namespace etalon {

/// An affine map, as the images of the three axes and of the origin.
struct Affine {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0, 0, 0};

    bool operator==(const Affine&) const = default;

    Vec3 vector(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
    Vec3 point(const Vec3& p) const { return vector(p) + origin; }

    /// Returns the factor by which it scales volumes; negative for a mirroring map.
    double determinant() const { return x.dot(y.cross(z)); }
};

/// Returns the factor by which it scales lengths, if that is the same in all directions up to the
/// roundings of float matrices: a rotation whose numbers are rounded to float, by up to 2^-25,
/// changes each of these products by less than 2^-23. The tolerance is that of four such matrices.
inline std::optional<double> scale_of(const Affine& map) {
    const auto& [x, y, z, origin] = map;
    const double xx = x.dot(x), tolerance = 0x1p-20 * xx;
    const auto is_small = [&](double difference) { return std::abs(difference) <= tolerance; };
    const bool alike = is_small(y.dot(y) - xx) && is_small(z.dot(z) - xx);
    const bool square = is_small(x.dot(y)) && is_small(y.dot(z)) && is_small(z.dot(x));
    if (!alike || !square) return std::nullopt;
    return std::cbrt(std::abs(map.determinant()));
}

inline bool is_finite(const Affine& map) {
    return is_finite(map.x) && is_finite(map.y) && is_finite(map.z) && is_finite(map.origin);
}

/// Composes two maps: first b, then a.
inline Affine operator*(const Affine& a, const Affine& b) {
    return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.origin)};
}

}  // namespace etalon
