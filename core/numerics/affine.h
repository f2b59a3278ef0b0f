#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// An affine map, as the images of the three axes and of the origin.
struct Affine {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0, 0, 0};

    Vec3 vector(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
    Vec3 point(const Vec3& p) const { return vector(p) + origin; }

    /// How it scales volumes; negative for one that mirrors.
    double determinant() const { return x.dot(y.cross(z)); }
};

inline bool is_finite(const Affine& map) {
    return is_finite(map.x) && is_finite(map.y) && is_finite(map.z) && is_finite(map.origin);
}

/// Composition: first b, then a.
inline Affine operator*(const Affine& a, const Affine& b) {
    return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.origin)};
}

}  // namespace etalon
