#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/intersect/cut_outs.h"
#include "core/scene/scene.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// Holes of the surfaces of a physical look: where an alpha is 0, by the rule of pbrt-v3.
class TexturedCutOuts : public CutOuts {
  public:
    /// Reads the images of the textures that alphas show, and keeps nothing of the look. `problems`
    /// gets the reasons why images are replaced by grey.
    TexturedCutOuts(const PhysicalLook& look, std::vector<std::string>& problems);

    bool is_hole(const Geometry& geometry, const SurfacePoint& point,
                 bool for_shadow) const override;

  private:
    struct Surface {
        NumberSlot alpha, shadow_alpha;
        std::uint32_t uv_offset;  ///< see SurfaceBinding
    };

    /// A texture of which only the zeros are kept.
    struct Mask {
        Mapping mapping;
        ZeroTexels zeros;
    };

    static std::vector<std::optional<Mask>> masks(const PhysicalLook& look,
                                                  std::vector<std::string>& problems);
    bool is_zero(const NumberSlot& alpha, const TexturePoint& place) const;

    std::vector<Surface> surfaces_;           ///< of each binding
    std::vector<std::optional<Mask>> masks_;  ///< of the textures for which one is enough
    Textures textures_;                       ///< the others that alphas show, at their places
    TextureValues values_;
};

/// Gives the geometry of a scene, and of its objects, the holes that its look asks for, if there
/// are any: whoever builds a backend for a scene of a file does this first. `problems` gets the
/// reasons why images are replaced by grey.
void make_cut_outs(Scene& scene, std::vector<std::string>& problems);

}  // namespace etalon
