#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/intersect/cut_outs.h"
#include "core/scene/scene.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// Alpha masks of physical materials: a surface has a hole where its alpha texture is 0, as in
/// pbrt-v3.
class TexturedCutOuts : public CutOuts {
  public:
    /// Reads the images of the alpha textures; keeps no reference to `look`. For each image that
    /// cannot be read and is replaced by grey, `problems` gets the reason.
    TexturedCutOuts(const PhysicalLook& look, std::vector<std::string>& problems);

    bool is_hole(const Geometry& geometry, const SurfacePoint& point,
                 bool for_shadow) const override;

  private:
    struct Surface {
        NumberSlot alpha, shadow_alpha;
        std::uint32_t uv_offset;  ///< see SurfaceBinding
    };

    /// An image texture of which only the positions of zero texels are kept.
    struct Mask {
        Mapping mapping;
        ZeroTexels zeros;
    };

    static std::vector<std::optional<Mask>> masks(const PhysicalLook& look,
                                                  std::vector<std::string>& problems);
    bool is_zero(const NumberSlot& alpha, const TexturePoint& place) const;

    std::vector<Surface> surfaces_;           ///< for each binding
    std::vector<std::optional<Mask>> masks_;  ///< for image textures whose zeros suffice
    Textures textures_;  ///< the other alpha textures, with their indices unchanged
    TextureValues values_;
};

/// Sets the cut-outs of a scene's geometry and of its objects if any material has an alpha texture.
/// Call it before a backend is built for a scene read from a file. For each image that cannot be
/// read and is replaced by grey, `problems` gets the reason.
void make_cut_outs(Scene& scene, std::vector<std::string>& problems);

}  // namespace etalon
