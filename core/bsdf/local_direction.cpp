#include "core/bsdf/local_direction.h"

namespace etalon {

Vec3f cosine_direction(const Vec3f& side, const Vec2& uv) {
    const auto a = static_cast<float>(2 * uv.x - 1), b = static_cast<float>(2 * uv.y - 1);
    if (a == 0 && b == 0) return {0, 0, std::copysign(1.0F, side.z)};
    const bool a_is_radius = std::abs(a) > std::abs(b);
    const float radius = a_is_radius ? a : b;
    const float angle = std::numbers::pi_v<float> / 4 * (a_is_radius ? b / a : a / b);
    const float near_axis = radius * std::cos(angle), off_axis = radius * std::sin(angle);
    const float z = std::sqrt(std::max(0.0F, 1 - radius * radius));
    return {a_is_radius ? near_axis : off_axis, a_is_radius ? off_axis : near_axis,
            std::copysign(z, side.z)};
}

}  // namespace etalon
