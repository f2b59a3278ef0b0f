// Subsurface scattering of materials.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/diffusion/subsurface.h"
#include "core/material/point_values.h"

namespace etalon {

/// The diffusion tables of materials, one for each pair of mean cosine and index.
class DiffusionTables {
  public:
    explicit DiffusionTables(const std::vector<PhysicalMaterial>& materials);

    /// Returns that of a material, whose index must be constant.
    template <class Material>
    const DiffusionTable& of(const Material& material) const {
        return tables_.at({material.g, material.boundary.eta.value});
    }

  private:
    std::map<std::pair<float, float>, DiffusionTable> tables_;
};

/// Returns whether a material scatters light below its surface anywhere.
bool may_scatter_below(const PhysicalMaterial& material);

/// Returns the subsurface scattering at a point; nothing if there is none or if light passes
/// through the surface.
std::optional<Subsurface> subsurface_at(const PhysicalMaterial& material,
                                        const DiffusionTables& tables, const PointValues& values);

/// Returns the subsurface scattering of a material that is the same everywhere; nothing for others.
std::optional<Subsurface> constant_subsurface(const PhysicalMaterial& material,
                                              const DiffusionTables& tables,
                                              const TextureValues& textures);

/// Returns the part of subsurface_at() for Burley's material.
std::optional<Subsurface> subsurface_of(const DisneyMaterial& material, const PointValues& values);

}  // namespace etalon
