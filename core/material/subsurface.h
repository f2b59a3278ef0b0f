// What materials say of light that goes below a surface and comes out elsewhere.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/diffusion/subsurface.h"
#include "core/material/point_values.h"

namespace etalon {

/// The tables that materials need, one for those of the same mean cosine and index.
class DiffusionTables {
  public:
    explicit DiffusionTables(const std::vector<PhysicalMaterial>& materials);

    /// That of a material; its border has one index.
    template <class Material>
    const DiffusionTable& of(const Material& material) const {
        return tables_.at({material.g, material.border.eta.value});
    }

  private:
    std::map<std::pair<float, float>, DiffusionTable> tables_;
};

/// Returns whether light is scattered below surfaces of a material anywhere.
bool may_scatter_below(const PhysicalMaterial& material);

/// What is below a point of a surface; nothing where light goes through the surface or not at all.
std::optional<Subsurface> subsurface_at(const PhysicalMaterial& material,
                                        const DiffusionTables& tables, const PointValues& values);

/// What is below a material that has the same everywhere; nothing for others.
std::optional<Subsurface> constant_subsurface(const PhysicalMaterial& material,
                                              const DiffusionTables& tables,
                                              const TextureValues& textures);

/// Burley's part of the above.
std::optional<Subsurface> subsurface_of(const DisneyMaterial& material, const PointValues& values);

}  // namespace etalon
