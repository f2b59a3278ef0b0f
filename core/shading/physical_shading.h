#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"
#include "core/material/subsurface.h"
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

    /// What scatters light below the surface where it goes through at a point; null: nothing does.
    /// `room` is as above.
    const Subsurface* subsurface(const PhysicalSurface& at, std::optional<Subsurface>& room) const {
        const Traits& traits = traits_[at.binding->material];
        if (!traits.may_scatter_below) return nullptr;
        return traits.subsurface ? &*traits.subsurface : textured_subsurface(at, room);
    }

    /// Whether that is the same at all points of its surfaces, and stays where it is.
    bool is_lasting(const PhysicalSurface& at) const {
        return traits_[at.binding->material].subsurface.has_value();
    }

    /// Number of the material whose surfaces bound what is below a surface: of a mix, that of its
    /// first part, as in pbrt-v3.
    std::uint32_t material_below(const PhysicalSurface& at) const;

  private:
    /// What can be said of a material without a point.
    struct Traits {
        std::optional<LobeList> lobes;  ///< if the same everywhere
        bool needs_coordinates;
        bool may_scatter_below = false;
        std::optional<Subsurface> subsurface{};  ///< if the same everywhere
    };
    Traits traits_of(const PhysicalMaterial& material) const;
    MaterialPoint material_point(const PhysicalSurface& at) const;
    const Subsurface* textured_subsurface(const PhysicalSurface& at,
                                          std::optional<Subsurface>& room) const;

    const Scene& scene_;
    TextureValues textures_;
    DiffusionTables tables_;
    bool has_passages_;
    std::vector<Traits> traits_;  ///< of each material
};

}  // namespace etalon
