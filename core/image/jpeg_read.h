#pragma once

#include <cstdio>

#include "core/base/result.h"
#include "core/image/compact_image.h"
#include "core/image/extent.h"
#include "core/image/image.h"

namespace etalon {

/// Reads a JPEG file with libjpeg: one byte for each channel, taken as sRGB. CMYK is converted to
/// RGB. Neither orientation nor colour profile is applied. A file that ends early is an error. The
/// error message does not name the file. May throw std::bad_alloc.
Result<Image> read_jpeg(std::FILE* file, Extent extent);

/// Reads the same colours in the form that takes least memory.
Result<CompactImage> read_compact_jpeg(std::FILE* file);

}  // namespace etalon
