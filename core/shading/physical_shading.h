#pragma once

#include <string>
#include <vector>

#include "core/bsdf/bsdf.h"
#include "core/shading/physical_surface.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// Scattering at the surfaces of a scene of a physical look: its materials with its textures.
class PhysicalShading {
  public:
    /// `scene` must outlive it. `problems` gets the reasons why images are replaced by constants.
    PhysicalShading(const Scene& scene, std::vector<std::string>& problems);

    enum class RayKind { seeing, shadow };

    /// Whether any surface lets rays pass where a texture says so.
    bool has_cut_outs() const { return has_cut_outs_; }

    /// Whether there is nothing at this point of the surface for a ray of that kind.
    bool is_cut_out(const PhysicalSurface& at, RayKind kind) const;

    /// Whether the surface is none: a ray passes.
    bool is_passed(const PhysicalSurface& at) const;

    Bsdf scattering(const PhysicalSurface& at) const;

  private:
    const Scene& scene_;
    TextureValues textures_;
    bool has_cut_outs_;
    bool uses_coordinates_;  ///< whether any material asks for surface coordinates
};

}  // namespace etalon
