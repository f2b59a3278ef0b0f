// How much of an image that textures show is kept in memory.
#pragma once

#include <cstddef>

#include "core/image/image.h"
#include "core/scene/texture.h"

namespace etalon {

/// What a texture makes of an image: colours, or their luminance.
enum class Shown : std::uint8_t { colors, numbers };

/// The form in which the texels of an image are kept. Those of a file of bytes, of up to four
/// channels, take four bytes or less each.
struct KeptTexels {
    enum class Form : std::uint8_t {
        bytes,   ///< as in the file, to be decoded by a table
        floats,  ///< what is shown
        packed,  ///< what is shown, each colour in four bytes
    };

    Form form = Form::bytes;
    bool same_as_file = true;
    int width = 0, height = 0, channels = 0;

    std::size_t bytes() const;
};

/// Returns the form in which an image, of which the header is enough, is kept for what a texture
/// shows of it.
KeptTexels kept_texels(const Image& image, Shown what, bool decode_srgb);

}  // namespace etalon
