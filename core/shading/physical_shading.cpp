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

}  // namespace

PhysicalShading::PhysicalShading(const Scene& scene, std::vector<std::string>& problems)
    : scene_(scene),
      textures_(scene.physical().textures, problems),
      uses_coordinates_(needs_coordinates(scene.physical())) {}

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
