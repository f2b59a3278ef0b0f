// Random places on and about the round things there are.
#pragma once

#include <numbers>

#include "core/numerics/random.h"

namespace etalon {

inline constexpr double turn = 2 * std::numbers::pi;

/// Of unit length, at `angle` about the unit vector `axis`.
inline Vec3 across(const Vec3& axis, double angle) {
    Vec3 u, v;
    orthonormal_basis(axis, u, v);
    return std::cos(angle) * u + std::sin(angle) * v;
}

/// In the unit ball, more of them near its centre.
inline Vec3 in_ball(Random& random) {
    const double radius = random.uniform();
    return radius * random.direction();
}

/// A factor that moves a surface in or out of a ray's way: off 1 by 10^-1 down to 10^finest.
inline double nearly_one(double finest, Random& random) {
    const double sign = random.sign();
    return 1 + sign * random.magnitude(finest, -1);
}

}  // namespace etalon
