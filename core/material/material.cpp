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

BsdfFrame bsdf_frame(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                     const TextureValues& textures, const MaterialPoint& point) {
    const NumberSlot& bump = shape_giving(material, all).bump;
    if (bump.texture == no_index) return {point.ng, point.ns, point.dpdu};
    const ShadingFrame frame = bumped(bump, textures, point);
    return {point.ng, frame.ns, frame.tangent};
}

bool is_bumpy(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all) {
    return shape_giving(material, all).bump.texture != no_index;
}

LobeList lobes_at(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                  const TextureValues& textures, const TexturePoint& point) {
    LobeList lobes;
    add_material(material, all, PointValues(textures, point), lobes);
    return lobes;
}

std::optional<LobeList> constant_lobes(const PhysicalMaterial& material,
                                       const std::vector<PhysicalMaterial>& all,
                                       const TextureValues& textures) {
    const PointValues anywhere(textures, {Vec2(0), Vec3(0)});
    LobeList lobes;
    add_material(material, all, anywhere, lobes);
    if (anywhere.asked_point()) return std::nullopt;
    return lobes;
}

Bsdf scattering(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                const TextureValues& textures, const MaterialPoint& point) {
    return {bsdf_frame(material, all, textures, point),
            lobes_at(material, all, textures, {point.uv, point.position})};
}

}  // namespace etalon
