// Vectors, boxes and colours are Imath's; this header only gives them the project's names.
#pragma once

#include <Imath/ImathBox.h>
#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace etalon {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;
using Vec3f = Imath::V3f;
using Box3 = Imath::Box3d;
using Box3f = Imath::Box3f;
using Color = Imath::C3f;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

inline double max_abs(const Vec3& v) {
    return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}

/// Returns the sum of magnitudes: between the length and sqrt(3) times the length.
inline double sum_abs(const Vec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

inline Vec3 abs(const Vec3& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_finite(const Color& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

/// Returns `v` divided by its length, whose square must be in the range of double and not zero.
inline Vec3 normalized(const Vec3& v) {
    return v / std::sqrt(v.dot(v));
}

/// Calls visit(point) for the eight corners of a box.
template <class Visit>
void for_each_corner(const Box3& box, const Visit& visit) {
    for (unsigned i = 0; i < 8; ++i) {
        visit(Vec3((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                   (i & 4) != 0 ? box.max.z : box.min.z));
    }
}

/// Returns the index (0, 1, 2) of the component of largest magnitude; the lower index on a tie.
inline int dominant_axis(const Vec3& v) {
    const Vec3 a = abs(v);
    if (a.x >= a.y && a.x >= a.z) return 0;
    return a.y >= a.z ? 1 : 2;
}

/// Sets u and v such that (u, v, n) is a right-handed orthonormal basis for the unit vector `n`
/// (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
inline void orthonormal_basis(const Vec3& n, Vec3& u, Vec3& v) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    u = Vec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    v = Vec3(b, sign + n.y * n.y * a, -n.y);
}

}  // namespace etalon
