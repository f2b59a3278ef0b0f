#include "core/material/bump.h"

#include <algorithm>

namespace etalon {

ShadingFrame bumped(const NumberSlot& bump, const TextureValues& textures,
                    const MaterialPoint& point) {
    // Steps in u and v. pbrt-v3's are half a sample's footprint. These are below the bumps'
    // features, and far above the roundings of heights.
    constexpr double largest = 0x1p-14;
    const DifferenceSteps most = textures.difference_steps(bump);
    const auto step_along = [&](const Vec3& derivative) {
        return std::min({largest, most.uv, most.space / derivative.length()});
    };
    const double step_u = step_along(point.dpdu), step_v = step_along(point.dpdv);
    const auto height = [&](const Vec2& uv, const Vec3& position) {
        return double(textures.number(bump, {uv, position}));
    };
    const double here = height(point.uv, point.position);
    const double rise_u =
        height(point.uv + Vec2(step_u, 0), point.position + step_u * point.dpdu) - here;
    const double rise_v =
        height(point.uv + Vec2(0, step_v), point.position + step_v * point.dpdv) - here;
    const Vec3 dpdu = point.dpdu + rise_u / step_u * point.ns + here * point.dndu;
    const Vec3 dpdv = point.dpdv + rise_v / step_v * point.ns + here * point.dndv;

    const Vec3 across = dpdu.cross(dpdv);
    const double length2 = across.dot(across);
    if (!(length2 > 0) || !std::isfinite(length2)) return {point.ns, point.dpdu};
    const Vec3 ns = across / std::sqrt(length2);
    return {ns.dot(point.ng) < 0 ? -ns : ns, dpdu};
}

}  // namespace etalon
