#include "core/material/material.h"

#include "core/material/bump.h"
#include "core/material/mixed.h"

namespace etalon {

TrowbridgeReitz PointValues::facets(const Roughness& roughness) const {
    const auto alpha = [&](const NumberSlot& slot) {
        const float value = number(slot);
        return roughness.remap ? alpha_of_roughness(value) : value;
    };
    const NumberSlot &u = roughness.u, &v = roughness.v;
    const float alpha_u = alpha(u);
    return {alpha_u, u.texture == v.texture && u.value == v.value ? alpha_u : alpha(v)};
}

Bsdf scattering(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                const TextureValues& textures, const MaterialPoint& point) {
    const PointValues values{textures, {point.uv, point.position}};
    const NumberSlot& bump = shape_giving(material, all).bump;
    const ShadingFrame frame =
        bump.texture == no_index ? ShadingFrame{point.ns, point.dpdu} : bumped(bump, values, point);
    Bsdf bsdf(point.ng, frame.ns, frame.tangent);
    add_material(material, all, values, bsdf);
    return bsdf;
}

}  // namespace etalon
