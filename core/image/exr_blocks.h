#pragma once

#include <cstdint>
#include <vector>

#include "core/image/rendered_image.h"

namespace etalon {

/// Names of the channels for the image's colours.
inline constexpr const char* exr_color_names[] = {"R", "G", "B"};

/// Returns the blocks of rows of an OpenEXR file with ZIP compression, whose channels are the
/// image's colours and its other channels: see encode_exr(). Uses all threads.
std::vector<std::vector<std::uint8_t>> make_exr_blocks(const RenderedImage& image);

}  // namespace etalon
