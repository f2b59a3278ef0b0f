// The form in which the images of textures are kept in memory.
#pragma once

#include <cstddef>

#include "core/image/image.h"
#include "core/scene/texture.h"

namespace etalon {

/// Values that a texture takes from an image: colours, or their luminance.
enum class Shown : std::uint8_t { colors, numbers };

/// Storage of the texels of an image. Those of a file of bytes, with up to four channels, take four
/// bytes or less each.
struct KeptTexels {
    enum class Form : std::uint8_t {
        bytes,   ///< as in the file, to be decoded by a table
        floats,  ///< the texture's values
        packed,  ///< the texture's values, each colour in four bytes
    };

    Form form = Form::bytes;
    bool same_as_file = true;
    int width = 0, height = 0, channels = 0;

    std::size_t bytes() const;
};

/// Returns the form in which an image is kept for a use by a texture. Only the header of the image
/// is needed.
KeptTexels kept_texels(const Image& image, Shown what, bool decode_srgb);

}  // namespace etalon
