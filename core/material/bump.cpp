#include "core/material/bump.h"

namespace etalon {

ShadingFrame bumped(const NumberSlot& bump, const TextureValues& textures,
                    const MaterialPoint& point) {
    // Step in u and v. pbrt-v3's is half a sample's footprint. This one is below any visible bump,
    // and far above the roundings of heights.
    constexpr double step = 0x1p-14;
    const auto height = [&](const Vec2& uv, const Vec3& position) {
        return double(textures.number(bump, {uv, position}));
    };
    const double here = height(point.uv, point.position);
    const double rise_u =
        height(point.uv + Vec2(step, 0), point.position + step * point.dpdu) - here;
    const double rise_v =
        height(point.uv + Vec2(0, step), point.position + step * point.dpdv) - here;
    const Vec3 dpdu = point.dpdu + rise_u / step * point.ns + here * point.dndu;
    const Vec3 dpdv = point.dpdv + rise_v / step * point.ns + here * point.dndv;

    const Vec3 across = dpdu.cross(dpdv);
    const double length2 = across.dot(across);
    if (!(length2 > 0) || !std::isfinite(length2)) return {point.ns, point.dpdu};
    const Vec3 ns = across / std::sqrt(length2);
    return {ns.dot(point.ng) < 0 ? -ns : ns, dpdu};
}

}  // namespace etalon
