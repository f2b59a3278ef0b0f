// Extents of the images of a sphere and of a cylinder, and unit vectors on them.
#pragma once

#include "core/numerics/rounding.h"

namespace etalon {

/// Returns the length of (a, b, c) for each axis, rounded up: the half size of the image of the
/// unit sphere under the map with these columns.
inline Vec3 reach(const Vec3& a, const Vec3& b, const Vec3& c = Vec3(0)) {
    constexpr double above = 1 + 8 * unit_roundoff;
    return above *
           Vec3(std::hypot(a.x, b.x, c.x), std::hypot(a.y, b.y, c.y), std::hypot(a.z, b.z, c.z));
}

/// Returns the box of all points within `reach` of one between `low` and `high`, rounded outward.
inline Box3 box_around(const Vec3& low, const Vec3& high, const Vec3& reach) {
    Box3 box(low - reach, high + reach);
    for (int k = 0; k < 3; ++k) {
        box.min[k] = std::nextafter(box.min[k], -infinity);
        box.max[k] = std::nextafter(box.max[k], infinity);
    }
    return box;
}

/// Moves a point next to a surface onto it, the shortest way to first order: along the gradient of
/// a function that is zero on the surface and `value` at the point.
inline Vec3 moved_onto_surface(const Vec3& point, const Vec3& gradient, double value) {
    const Vec3 normal = unit_vector(gradient);
    return point - (value / gradient.dot(normal)) * normal;
}

}  // namespace etalon
