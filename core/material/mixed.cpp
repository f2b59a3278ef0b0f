#include "core/material/mixed.h"

#include "core/material/add_lobes.h"

namespace etalon {
namespace {

constexpr int most_nested = 8;

/// Adds a part of a mix: the material's lobes, scaled by `part`.
void add_part(std::uint32_t material, const Color& part, const std::vector<PhysicalMaterial>& all,
              const PointValues& values, LobeList& lobes, int depth) {
    if (is_black(part)) return;
    const std::size_t first = lobes.size();
    add_material(all[material], all, values, lobes, depth);
    lobes.scale(first, part);
}

}  // namespace

const PhysicalMaterial& shape_giving(const PhysicalMaterial& material,
                                     const std::vector<PhysicalMaterial>& all) {
    const PhysicalMaterial* giving = &material;
    for (int depth = 0; depth < most_nested; ++depth) {
        const auto* mixed = std::get_if<MixedMaterial>(&giving->kind);
        if (!mixed) break;
        giving = &all[mixed->first];
    }
    return *giving;
}

void add_material(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                  const PointValues& values, LobeList& lobes, int depth) {
    std::visit(
        [&](const auto& kind) {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (std::is_same_v<Kind, MixedMaterial>) {
                if (depth == most_nested) return;
                const Color amount = values.part(kind.amount);
                const auto rest = [](float part) { return std::max(0.0F, 1 - part); };
                add_part(kind.first, amount, all, values, lobes, depth + 1);
                add_part(kind.second, {rest(amount.x), rest(amount.y), rest(amount.z)}, all, values,
                         lobes, depth + 1);
            } else if constexpr (!std::is_same_v<Kind, NoMaterial>) {
                add_lobes(kind, values, lobes);
            }
        },
        material.kind);
}

}  // namespace etalon
