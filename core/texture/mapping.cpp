#include "core/texture/mapping.h"

#include <cmath>
#include <numbers>

namespace etalon {
namespace {

using std::numbers::pi;

Vec2 coordinates(const UvMapping& m, const TexturePoint& point) {
    return {m.u_scale * point.uv.x + m.u_offset, m.v_scale * point.uv.y + m.v_offset};
}

Vec2 coordinates(const SphericalMapping& m, const TexturePoint& point) {
    const Vec3 p = m.to_texture.point(point.position);
    const double theta = std::atan2(std::hypot(p.x, p.y), p.z), phi = std::atan2(p.y, p.x);
    return {theta / pi, (phi < 0 ? phi + 2 * pi : phi) / (2 * pi)};
}

Vec2 coordinates(const CylindricalMapping& m, const TexturePoint& point) {
    const Vec3 p = m.to_texture.point(point.position);
    const double distance = std::sqrt(p.dot(p));
    return {(pi + std::atan2(p.y, p.x)) / (2 * pi), distance > 0 ? p.z / distance : 1.0};
}

Vec2 coordinates(const PlanarMapping& m, const TexturePoint& point) {
    return {m.u_offset + point.position.dot(m.u_axis), m.v_offset + point.position.dot(m.v_axis)};
}

}  // namespace

Vec2 texture_coordinates(const Mapping& mapping, const TexturePoint& point) {
    return std::visit([&](const auto& m) { return coordinates(m, point); }, mapping);
}

}  // namespace etalon
