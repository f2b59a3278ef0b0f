#pragma once

#include <string>

#include "core/base/result.h"
#include "core/image/extent.h"
#include "core/image/image.h"
#include "core/image/rendered_image.h"

namespace etalon {

/// Name of an integer attribute that is 1 if the file has display values.
inline constexpr const char* display_colors_attribute = "displayColors";

/// Returns an OpenEXR file in memory: scan lines of 32-bit float R, G, B with ZIP compression
/// (blocks that compress little are stored as they are, which the format allows), Rec. 709
/// chromaticities, the image's window as data window inside its frame as display window, and its
/// metadata as attributes of the same names and types. Where OpenEXR has a standard attribute of a
/// name (worldToCamera, ...), the type must be the standard one. The image's channels follow as
/// FLOAT and UINT. Display values are decoded, unless the image keeps them. Uses all threads, with
/// the same bytes for any number of them. The image and each channel must have as many values as
/// the window has pixels.
Result<std::string> encode_exr(const RenderedImage& image);

/// Reads the data window of the first part of a file as floats: R, G, B (0 for a missing one) or Y
/// alone, from scan lines or tiles of half, float or integer, or from deep scan lines, whose
/// samples are merged. Other layouts are refused, and so are sides above 65536 and files with
/// missing pixels. A failure's reason does not name the file.
Result<Image> read_exr(const std::string& path, Extent extent);

}  // namespace etalon
