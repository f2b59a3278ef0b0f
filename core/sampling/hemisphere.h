#pragma once

#include <cmath>
#include <numbers>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns a unit vector whose angle to the unit vector `normal` is cosine-distributed (density cos
/// / pi), for `uv` uniformly distributed in [0, 1)^2: a point of the unit disk lifted to the
/// hemisphere (Malley's method).
inline Vec3 cosine_direction(const Vec3& normal, const Vec2& uv) {
    Vec3 u, v;
    orthonormal_basis(normal, u, v);
    const double radius = std::sqrt(uv.x), angle = 2 * std::numbers::pi * uv.y;
    return radius * std::cos(angle) * u + radius * std::sin(angle) * v +
           std::sqrt(1 - uv.x) * normal;
}

}  // namespace etalon
