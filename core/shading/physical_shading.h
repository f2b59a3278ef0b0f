#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"
#include "core/shading/physical_surface.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// Scattering at the surfaces of a scene of a physical look: its materials with its textures.
class PhysicalShading {
  public:
    /// `scene` must outlive it. `problems` gets the reasons why images are replaced by constants.
    PhysicalShading(const Scene& scene, std::vector<std::string>& problems);

    /// Whether any surface lets shadow rays pass because it has no material.
    bool has_passages() const { return has_passages_; }

    /// Whether the surface is none: a ray passes.
    bool is_passed(const PhysicalSurface& at) const;

    /// What scatters at a point.
    struct Scattering {
        BsdfFrame frame;
        const LobeList& lobes;
    };
    /// `room` takes lobes that are not those of all points of the surface, and must outlive what is
    /// returned.
    Scattering scattering(const PhysicalSurface& at, std::optional<LobeList>& room) const;

  private:
    /// What can be said of a material without a point.
    struct Traits {
        std::optional<LobeList> lobes;  ///< if the same everywhere
        bool needs_coordinates;
    };
    Traits traits_of(const PhysicalMaterial& material) const;
    MaterialPoint material_point(const PhysicalSurface& at) const;

    const Scene& scene_;
    TextureValues textures_;
    bool has_passages_;
    std::vector<Traits> traits_;  ///< of each material
};

}  // namespace etalon
