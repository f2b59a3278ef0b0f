// A point sampled on the shape of a light, the sphere around the shape, and densities.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/numerics/vec.h"

namespace etalon {

/// A point on a light's shape, sampled to be seen from another point.
struct AreaPoint {
    Vec3 position;
    Vec3 normal;  ///< unit, as the shape defines it
    double pdf;   ///< per steradian at the point from which it is seen; 0: not visible
};

/// Sphere around a shape.
struct BoundingSphere {
    Vec3 centre;
    double radius;
};

/// Returns the largest cosine, not below 0, between a unit vector and directions to a sphere.
/// `to_centre` is relative to the point from which it is seen.
inline double largest_cosine(const Vec3& normal, const Vec3& to_centre, double radius) {
    const double distance2 = to_centre.dot(to_centre), radius2 = radius * radius;
    if (distance2 <= radius2) return 1;
    const double distance = std::sqrt(distance2);
    const double cosine = std::clamp(normal.dot(to_centre) / distance, -1.0, 1.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const double sine_half = radius / distance, cos_half = std::sqrt(1 - sine_half * sine_half);
    if (cosine >= cos_half) return 1;
    return std::max(0.0, cosine * cos_half + sine * sine_half);  // of the difference of the angles
}

/// Converts a density per area to one per steradian at `from`.
inline double per_steradian(double per_area, const Vec3& from, const Vec3& position,
                            const Vec3& normal) {
    const Vec3 to_light = position - from;
    const double distance2 = to_light.dot(to_light), cosine = std::abs(normal.dot(to_light));
    return cosine > 0 ? per_area * distance2 * std::sqrt(distance2) / cosine : 0;
}

inline AreaPoint chosen_by_area(const Vec3& from, const Vec3& position, const Vec3& normal,
                                double area) {
    return {position, normal, per_steradian(1 / area, from, position, normal)};
}

}  // namespace etalon
