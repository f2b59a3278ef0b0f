#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/lazy_storage.h"
#include "core/material/material.h"
#include "core/material/subsurface.h"
#include "core/shading/physical_surface.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// Evaluates the physical materials of a scene, with their textures, at points of its surfaces.
class PhysicalShading {
  public:
    /// `scene` must outlive the object. For each image that cannot be read and is replaced by a
    /// constant, `problems` gets the reason.
    PhysicalShading(const Scene& scene, std::vector<std::string>& problems);

    /// Returns whether the scene has a null material, through which rays pass unchanged.
    bool has_null_materials() const { return has_null_materials_; }

    /// The BSDF at a point: its lobes and the frame in which they are given.
    struct Scattering {
        BsdfFrame frame;
        const LobeList& lobes;
    };
    /// Returns the BSDF at a point. Lobes that differ from point to point are stored in `room`,
    /// which must outlive the result.
    Scattering scattering(const PhysicalSurface& at, LazyStorage<LobeList>& room) const;

    /// Returns the subsurface scattering at a point, or null if the material has none. `room` is as
    /// above.
    const Subsurface* subsurface(const PhysicalSurface& at, LazyStorage<Subsurface>& room) const {
        const Traits& traits = traits_[at.binding->material];
        if (!traits.may_scatter_below) return nullptr;
        return traits.subsurface ? traits.subsurface.get() : textured_subsurface(at, room);
    }

    /// Returns whether subsurface() of the material is the same at all points; then the pointer
    /// stays valid.
    bool has_constant_subsurface(const PhysicalSurface& at) const {
        return traits_[at.binding->material].subsurface != nullptr;
    }

    /// Returns the number of the material whose surfaces bound the medium below a surface: for a
    /// mix, that of its first part, as in pbrt-v3.
    std::uint32_t material_below(const PhysicalSurface& at) const;

  private:
    /// Properties of a material that are the same at all points.
    struct Traits {
        std::optional<LobeList> lobes;  ///< if the same everywhere
        bool needs_coordinates;
        bool is_bumpy;
        bool may_scatter_below = false;
        /// If the same everywhere. Not in place: it is larger than all the rest, and rare.
        std::unique_ptr<const Subsurface> subsurface{};
    };
    Traits traits_of(const PhysicalMaterial& material) const;
    MaterialPoint material_point(const PhysicalSurface& at) const;
    const Subsurface* textured_subsurface(const PhysicalSurface& at,
                                          LazyStorage<Subsurface>& room) const;

    const Scene& scene_;
    TextureValues textures_;
    DiffusionTables tables_;
    bool has_null_materials_;
    std::vector<Traits> traits_;  ///< of each material
};

}  // namespace etalon
