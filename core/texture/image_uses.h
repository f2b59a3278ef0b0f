// The images that a scene's textures use, and as what.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/scene/texture.h"
#include "core/texture/kept_texels.h"

namespace etalon {

/// Use of an image by textures of one type.
struct ImageUse {
    std::size_t image;  ///< number among the images of the textures
    std::size_t file;   ///< number among the files
    Shown what;
};

/// All uses, in the order of the images.
struct ImageUses {
    std::vector<std::string> files;  ///< without duplicates
    std::vector<ImageUse> list;
};

ImageUses image_uses(const Textures& textures);

/// Key of a set of texels: uses with the same key share their texels.
struct TexelKey {
    std::size_t file;
    bool same_as_file = true;
    Shown what = Shown::colors;
    bool decode_srgb = false;
    Wrap wrap = Wrap::repeat;

    auto operator<=>(const TexelKey&) const = default;
};

TexelKey texel_key(const ImageUse& use, const KeptTexels& kept, const TextureImage& how);

/// Returns the image that replaces a file that cannot be read, as in pbrt-v3.
Image grey_pixel();

}  // namespace etalon
