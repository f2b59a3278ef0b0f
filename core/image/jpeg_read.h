#pragma once

#include <cstdio>

#include "core/base/result.h"
#include "core/image/extent.h"
#include "core/image/image.h"

namespace etalon {

/// A JPEG file, by libjpeg: bytes of its channels, as sRGB, those of inks (CMYK) as three; neither
/// its orientation nor a colour profile is applied. A failure's reason does not name the file; a
/// file that ends early is one. May throw std::bad_alloc.
Result<Image> read_jpeg(std::FILE* file, Extent extent);

}  // namespace etalon
