#pragma once

#include <string>

#include "core/base/result.h"
#include "core/image/extent.h"
#include "core/image/image.h"
#include "core/image/rendered_image.h"

namespace etalon {

/// An integer attribute, 1 where the file has display values.
inline constexpr const char* display_colors_attribute = "displayColors";

/// An OpenEXR file in memory: scan lines of 32-bit float R, G, B with ZIP compression, Rec. 709
/// chromaticities, the image's window as data window inside its frame as display window, and its
/// metadata as attributes of the same names and types. Where OpenEXR has a standard attribute of a
/// name (worldToCamera, ...), the type must be the standard one. Its channels follow as FLOAT and
/// UINT. Display values are decoded, unless the image keeps them. All threads make it, with the
/// same bytes for any number of them. `image` has the pixels, and as many values in each channel,
/// that its window asks for.
Result<std::string> encode_exr(const RenderedImage& image);

/// The data window of the first part of a file, as floats: R, G, B (0 where one of them is missing)
/// or Y alone. Scan lines or tiles, half, float or integer. Other layouts are refused, and so are
/// sides above 65536 and files with missing pixels. A failure's reason does not name the file.
Result<Image> read_exr(const std::string& path, Extent extent);

}  // namespace etalon
