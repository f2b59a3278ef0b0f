#include "core/shading/physical_shading.h"

#include <algorithm>

#include "core/material/material.h"

namespace etalon {
namespace {

/// Whether a lobe scatters differently along x and y.
bool is_anisotropic(const Lobe& lobe) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.facets; }) {
                return !kind.facets.is_isotropic();
            } else {
                return false;
            }
        },
        lobe);
}

bool can_be_zero(const NumberSlot& slot) {
    return slot.texture != no_index || slot.value == 0;
}

bool has_cut_out(const SurfaceBinding& binding) {
    return can_be_zero(binding.alpha) || can_be_zero(binding.shadow_alpha);
}

bool is_none(const PhysicalMaterial& material) {
    return std::holds_alternative<NoMaterial>(material.kind);
}

}  // namespace

PhysicalShading::PhysicalShading(const Scene& scene, std::vector<std::string>& problems)
    : scene_(scene),
      textures_(scene.physical().textures, problems),
      has_cut_outs_(std::ranges::any_of(scene.physical().bindings, has_cut_out)),
      has_passages_(has_cut_outs_ || std::ranges::any_of(scene.physical().materials, is_none)) {
    for (const PhysicalMaterial& m : scene.physical().materials) traits_.push_back(traits_of(m));
}

PhysicalShading::Traits PhysicalShading::traits_of(const PhysicalMaterial& material) const {
    const std::vector<PhysicalMaterial>& all = scene_.physical().materials;
    Traits traits{constant_lobes(material, all, textures_), true};
    traits.needs_coordinates = !traits.lobes || is_bumpy(material, all) ||
                               std::ranges::any_of(traits.lobes->span(), is_anisotropic);
    return traits;
}

bool PhysicalShading::is_cut_out(const PhysicalSurface& at, RayKind kind) const {
    const SurfaceBinding& binding = *at.binding;
    if (!has_cut_out(binding)) return false;
    const TexturePoint place{physical_parametrization(scene_, at).uv, at.point.position};
    return textures_.number(binding.alpha, place) == 0 ||
           (kind == RayKind::shadow && textures_.number(binding.shadow_alpha, place) == 0);
}

bool PhysicalShading::is_passed(const PhysicalSurface& at) const {
    return is_none(scene_.physical().materials[at.binding->material]);
}

MaterialPoint PhysicalShading::material_point(const PhysicalSurface& at) const {
    const Parametrization p = physical_parametrization(scene_, at);
    return {at.ng, at.ns, p.dpdu, p.dpdv, p.uv, at.point.position};
}

PhysicalShading::Scattering PhysicalShading::scattering(const PhysicalSurface& at,
                                                        std::optional<LobeList>& room) const {
    const Traits& traits = traits_[at.binding->material];
    if (!traits.needs_coordinates) return {{at.ng, at.ns}, *traits.lobes};
    const std::vector<PhysicalMaterial>& all = scene_.physical().materials;
    const PhysicalMaterial& material = all[at.binding->material];
    const MaterialPoint point = material_point(at);
    const BsdfFrame frame = bsdf_frame(material, all, textures_, point);
    if (traits.lobes) return {frame, *traits.lobes};
    return {frame, room.emplace(lobes_at(material, all, textures_, {point.uv, point.position}))};
}

}  // namespace etalon
