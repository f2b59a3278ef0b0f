// Random points on and around round shapes.
#pragma once

#include <numbers>

#include "core/numerics/random.h"

namespace etalon {

inline constexpr double turn = 2 * std::numbers::pi;

/// Returns a unit vector perpendicular to the unit vector `axis`, at `angle` about it.
inline Vec3 across(const Vec3& axis, double angle) {
    Vec3 u, v;
    orthonormal_basis(axis, u, v);
    return std::cos(angle) * u + std::sin(angle) * v;
}

/// Returns a point in the unit ball, more often near its centre.
inline Vec3 in_ball(Random& random) {
    const double radius = random.uniform();
    return radius * random.direction();
}

/// Returns a factor that moves a surface into or out of a ray's path: off 1 by 10^-1 down to
/// 10^finest.
inline double nearly_one(double finest, Random& random) {
    const double sign = random.sign();
    return 1 + sign * random.magnitude(finest, -1);
}

}  // namespace etalon
