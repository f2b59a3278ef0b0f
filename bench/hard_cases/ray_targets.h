// Targets and origins of rays, for any shape.
#pragma once

#include "core/intersect/ray.h"
#include "core/test_rays/directions.h"

namespace etalon::hard {

/// Rounds every coordinate to float.
Vec3 rounded(const Vec3& v);

/// Returns a point with float coordinates and no special position.
inline Vec3 usual_place() {
    return rounded({0.3, -0.7, 0.45});
}

/// Returns the far point of Embree's watertightness tests; all coordinates are floats.
inline Vec3 far_place() {
    return {148376, 1234, -223423};
}

/// Returns a point given in an odd frame, so that nothing is aligned with the axes by accident.
Vec3 tilted(double x, double y, double z);

/// Returns a uniform point of the unit disc perpendicular to `axis`, which is of unit length.
Vec3 in_disc(const Vec3& axis, Random& random);

/// Returns a unit vector along an axis, with zeros of either sign.
Vec3 axis_direction(Random& random);

/// Exponent of a relative offset far below any rounding.
inline constexpr double to_the_last_bit = -18;

inline Ray towards(const Vec3& origin, const Vec3& target) {
    return {origin, target - origin};
}

}  // namespace etalon::hard
