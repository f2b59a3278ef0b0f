#pragma once

#include <cmath>
#include <numbers>

#include "core/numerics/vec.h"

namespace etalon::test {

/// Maps the unit square to directions, with equal areas.
inline Vec3 uniform_direction(const Vec2& uv) {
    constexpr double turn = 2 * std::numbers::pi;
    const double z = 1 - 2 * uv.x, r = std::sqrt(1 - z * z);
    return {r * std::cos(turn * uv.y), r * std::sin(turn * uv.y), z};
}

}  // namespace etalon::test
