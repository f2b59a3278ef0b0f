// Image files by OpenImageIO, whose module is loaded at the first call.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"

namespace etalon {

/// The first image of any file OpenImageIO can read (jpg, png, hdr, pfm, tiff, ...), at most four
/// channels: 8-bit values stay bytes, others become floats, and no colour is converted. Integers of
/// any size count as sRGB, floats as linear.
Result<Image> read_oiio(const std::string& path);

/// A PNG file in memory, marked as sRGB, of width * height pixels R, G, B by rows from the top.
Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height);

}  // namespace etalon
