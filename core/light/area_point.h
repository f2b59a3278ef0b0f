#pragma once

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

/// Converts a density per area to one per steradian at `from`.
inline double per_steradian(double per_area, const Vec3& from, const Vec3& position,
                            const Vec3& normal) {
    const Vec3 way = position - from;
    const double distance2 = way.dot(way), cosine = std::abs(normal.dot(way));
    return cosine > 0 ? per_area * distance2 * std::sqrt(distance2) / cosine : 0;
}

inline AreaPoint chosen_by_area(const Vec3& from, const Vec3& position, const Vec3& normal,
                                double area) {
    return {position, normal, per_steradian(1 / area, from, position, normal)};
}

}  // namespace etalon
