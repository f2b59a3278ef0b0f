#include "core/shading/physical_shading.h"

#include <algorithm>

#include "core/material/material.h"

namespace etalon {
namespace {

/// Whether some material scatters differently along u and v.
bool is_anisotropic(const PhysicalMaterial& material) {
    return std::visit(
        [](const auto& m) {
            if constexpr (requires { m.roughness; }) {
                return m.roughness.u.value != m.roughness.v.value;
            } else {
                return false;
            }
        },
        material.kind);
}

bool needs_coordinates(const PhysicalLook& look) {
    return !look.textures.numbers.empty() || !look.textures.colors.empty() ||
           std::ranges::any_of(look.materials, is_anisotropic);
}

bool can_be_zero(const NumberSlot& slot) {
    return slot.texture != no_index || slot.value == 0;
}

bool has_cut_out(const SurfaceBinding& binding) {
    return can_be_zero(binding.alpha) || can_be_zero(binding.shadow_alpha);
}

}  // namespace

PhysicalShading::PhysicalShading(const Scene& scene, std::vector<std::string>& problems)
    : scene_(scene),
      textures_(scene.physical().textures, problems),
      has_cut_outs_(std::ranges::any_of(scene.physical().bindings, has_cut_out)),
      uses_coordinates_(needs_coordinates(scene.physical())) {}

bool PhysicalShading::is_cut_out(const PhysicalSurface& at, RayKind kind) const {
    const SurfaceBinding& binding = *at.binding;
    if (!has_cut_out(binding)) return false;
    const TexturePoint place{physical_parametrization(scene_, at).uv, at.point.position};
    return textures_.number(binding.alpha, place) == 0 ||
           (kind == RayKind::shadow && textures_.number(binding.shadow_alpha, place) == 0);
}

bool PhysicalShading::is_passed(const PhysicalSurface& at) const {
    const PhysicalMaterial& material = scene_.physical().materials[at.binding->material];
    return std::holds_alternative<NoMaterial>(material.kind);
}

Bsdf PhysicalShading::scattering(const PhysicalSurface& at) const {
    const std::vector<PhysicalMaterial>& all = scene_.physical().materials;
    MaterialPoint point{at.ng, at.ns, Vec3(0), Vec3(0), Vec2(0), at.point.position};
    if (uses_coordinates_) {
        const Parametrization p = physical_parametrization(scene_, at);
        point.uv = p.uv;
        point.dpdu = p.dpdu;
        point.dpdv = p.dpdv;
    }
    return etalon::scattering(all[at.binding->material], all, textures_, point);
}

}  // namespace etalon
