// Directions in the local frame of a shading normal, which is z. All point away from the surface.
#pragma once

#include <numbers>

#include "core/numerics/vec.h"

namespace etalon {

inline constexpr float inverse_pi = std::numbers::inv_pi_v<float>;

inline bool same_side(const Vec3f& a, const Vec3f& b) {
    return a.z * b.z > 0;
}

inline float sine_squared(const Vec3f& w) {
    return w.x * w.x + w.y * w.y;
}

inline Vec3f normalized(const Vec3f& v) {
    return v / std::sqrt(v.dot(v));
}

inline float mean(const Color& c) {
    return (c.x + c.y + c.z) / 3;
}

inline bool is_black(const Color& c) {
    return c.x == 0 && c.y == 0 && c.z == 0;
}

/// Returns a direction on the side of `side` whose angle to the normal is cosine-distributed
/// (density cos / pi), for `uv` uniformly distributed in [0, 1)^2: a point of the unit disk, by
/// Shirley and Chiu's concentric map (1997), lifted to the hemisphere.
Vec3f cosine_direction(const Vec3f& side, const Vec2& uv);

}  // namespace etalon
