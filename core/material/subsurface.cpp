#include "core/material/subsurface.h"

#include "core/material/add_lobes.h"

namespace etalon {
namespace {

/// True if a material is of one of the kinds that need a table.
template <class Kind>
constexpr bool has_table =
    std::is_same_v<Kind, SubsurfaceMaterial> || std::is_same_v<Kind, KdSubsurfaceMaterial>;

Subsurface below(const SubsurfaceMaterial& material, const DiffusionTable& table,
                 const PointValues& values) {
    return {TabulatedProfile(table, material.factor * values.part(material.absorption),
                             material.factor * values.part(material.scattering)),
            material.boundary.eta.value};
}

Subsurface below(const KdSubsurfaceMaterial& material, const DiffusionTable& table,
                 const PointValues& values) {
    const Color effective = values.part(material.albedo);
    const Color free_path = material.unit * values.part(material.free_path);
    Color absorption(0), scattering(0);
    for (int c = 0; c < 3; ++c) {
        const float albedo = table.albedo_of(effective[c]);
        if (!(free_path[c] > 0)) continue;  // lets nothing out, as in pbrt-v3
        scattering[c] = albedo / free_path[c];
        absorption[c] = (1 - albedo) / free_path[c];
    }
    return {TabulatedProfile(table, absorption, scattering), material.boundary.eta.value};
}

}  // namespace

DiffusionTables::DiffusionTables(const std::vector<PhysicalMaterial>& materials) {
    const auto add = [&](const auto& kind) {
        if constexpr (has_table<std::decay_t<decltype(kind)>>) {
            const float eta = kind.boundary.eta.value;
            tables_.try_emplace({kind.g, eta}, kind.g, eta);
        }
    };
    for (const PhysicalMaterial& material : materials) std::visit(add, material.kind);
}

bool may_scatter_below(const PhysicalMaterial& material) {
    if (const auto* disney = std::get_if<DisneyMaterial>(&material.kind)) {
        const ColorSlot& distance = disney->scatter_distance;
        return !disney->thin && (distance.texture != no_index || !is_black(distance.value));
    }
    return std::visit([](const auto& kind) { return has_table<std::decay_t<decltype(kind)>>; },
                      material.kind);
}

std::optional<Subsurface> subsurface_at(const PhysicalMaterial& material,
                                        const DiffusionTables& tables, const PointValues& values) {
    return std::visit(
        [&](const auto& kind) -> std::optional<Subsurface> {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (has_table<Kind>) {
                return below(kind, tables.of(kind), values);
            } else if constexpr (std::is_same_v<Kind, DisneyMaterial>) {
                return subsurface_of(kind, values);
            } else {
                return std::nullopt;
            }
        },
        material.kind);
}

std::optional<Subsurface> constant_subsurface(const PhysicalMaterial& material,
                                              const DiffusionTables& tables,
                                              const TextureValues& textures) {
    const PointValues anywhere(textures, {Vec2(0), Vec3(0)});
    const std::optional<Subsurface> same = subsurface_at(material, tables, anywhere);
    return anywhere.asked_point() ? std::nullopt : same;
}

void add_lobes(const SubsurfaceMaterial& material, const PointValues& values, LobeList& lobes) {
    add_lobes(material.boundary, values, lobes);
}

void add_lobes(const KdSubsurfaceMaterial& material, const PointValues& values, LobeList& lobes) {
    add_lobes(material.boundary, values, lobes);
}

}  // namespace etalon
