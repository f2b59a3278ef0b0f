#include "core/shading/physical_shading.h"

#include <algorithm>

#include "core/intersect/normal_change.h"
#include "core/material/mixed.h"

namespace etalon {
namespace {

/// Returns whether a lobe scatters differently along x and y.
bool is_anisotropic(const Lobe& lobe) {
    return visit_lobe(
        [](const auto& kind) {
            if constexpr (requires { kind.facets; }) {
                return !kind.facets.is_isotropic();
            } else {
                return false;
            }
        },
        lobe);
}

bool is_none(const PhysicalMaterial& material) {
    return std::holds_alternative<NoMaterial>(material.kind);
}

}  // namespace

PhysicalShading::PhysicalShading(const Scene& scene, std::vector<std::string>& problems)
    : scene_(scene),
      textures_(scene.physical().textures, problems),
      tables_(scene.physical().materials),
      has_null_materials_(std::ranges::any_of(scene.physical().materials, is_none)) {
    traits_.reserve(scene.physical().materials.size());
    for (const PhysicalMaterial& m : scene.physical().materials) traits_.push_back(traits_of(m));
}

PhysicalShading::Traits PhysicalShading::traits_of(const PhysicalMaterial& material) const {
    const std::vector<PhysicalMaterial>& all = scene_.physical().materials;
    Traits traits{constant_lobes(material, all, textures_), true, is_bumpy(material, all)};
    traits.needs_coordinates = !traits.lobes || traits.is_bumpy ||
                               std::ranges::any_of(traits.lobes->span(), is_anisotropic);
    const PhysicalMaterial& below = shape_giving(material, all);
    traits.may_scatter_below = may_scatter_below(below);
    if (traits.may_scatter_below) {
        const auto constant = constant_subsurface(below, tables_, textures_);
        if (constant) traits.subsurface = std::make_unique<const Subsurface>(*constant);
    }
    return traits;
}

const Subsurface* PhysicalShading::textured_subsurface(const PhysicalSurface& at,
                                                       LazyStorage<Subsurface>& room) const {
    const MaterialPoint point = material_point(at);
    const std::optional<Subsurface> found =
        subsurface_at(scene_.physical().materials[material_below(at)], tables_,
                      PointValues(textures_, {point.uv, point.position}));
    return found ? &room.emplace([&] { return *found; }) : nullptr;
}

std::uint32_t PhysicalShading::material_below(const PhysicalSurface& at) const {
    const std::vector<PhysicalMaterial>& all = scene_.physical().materials;
    return static_cast<std::uint32_t>(&shape_giving(all[at.binding->material], all) - all.data());
}

MaterialPoint PhysicalShading::material_point(const PhysicalSurface& at) const {
    const Parametrization p = physical_parametrization(scene_, at);
    MaterialPoint point{at.ng, at.ns, p.dpdu, p.dpdv, p.uv, at.point.position};
    if (!traits_[at.binding->material].is_bumpy) return point;
    const double sign = at.binding->flipped ? -1 : 1;
    point.dndu = sign * normal_change(scene_.geometry, at.point, p.dpdu);
    point.dndv = sign * normal_change(scene_.geometry, at.point, p.dpdv);
    return point;
}

PhysicalShading::Scattering PhysicalShading::scattering(const PhysicalSurface& at,
                                                        LazyStorage<LobeList>& room) const {
    const Traits& traits = traits_[at.binding->material];
    if (!traits.needs_coordinates) return {{at.ng, at.ns}, *traits.lobes};
    const std::vector<PhysicalMaterial>& all = scene_.physical().materials;
    const PhysicalMaterial& material = all[at.binding->material];
    const MaterialPoint point = material_point(at);
    const BsdfFrame frame = bsdf_frame(material, all, textures_, point);
    if (traits.lobes) return {frame, *traits.lobes};
    const auto make = [&] {
        return lobes_at(material, all, textures_, {point.uv, point.position});
    };
    return {frame, room.emplace(make)};
}

}  // namespace etalon
