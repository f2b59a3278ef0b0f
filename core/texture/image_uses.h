// Which images a scene's textures show, and as what.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/scene/texture.h"
#include "core/texture/kept_texels.h"

namespace etalon {

/// An image as textures of one type show it.
struct ImageUse {
    std::size_t image;  ///< number among the images of the textures
    std::size_t file;   ///< number among the files
    Shown what;
};

/// All of them, in the order of the images.
struct ImageUses {
    std::vector<std::string> files;  ///< each once
    std::vector<ImageUse> list;
};

ImageUses image_uses(const Textures& textures);

/// Tells sets of texels apart: uses of one key share theirs.
struct TexelKey {
    std::size_t file;
    bool same_as_file = true;
    Shown what = Shown::colors;
    bool decode_srgb = false;
    Wrap wrap = Wrap::repeat;

    auto operator<=>(const TexelKey&) const = default;
};

TexelKey texel_key(const ImageUse& use, const KeptTexels& kept, const TextureImage& how);

/// What is shown of a file that cannot be read, as in pbrt-v3.
Image grey_pixel();

}  // namespace etalon
