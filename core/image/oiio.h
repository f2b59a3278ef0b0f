#pragma once

#include <string>

#include "core/base/result.h"
#include "core/image/extent.h"
#include "core/image/image.h"

namespace etalon {

/// Reads the first image of any file that OpenImageIO can read (hdr, pfm, tiff, ...), at most four
/// channels. 8-bit values stay bytes, others become floats, and no colour is converted. Integers of
/// any size count as sRGB, floats as linear. The module is loaded at the first call; without it all
/// calls fail. A failure's reason does not name the file.
Result<Image> read_oiio(const std::string& path, Extent extent);

}  // namespace etalon
