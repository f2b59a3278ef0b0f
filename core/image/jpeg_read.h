#pragma once

#include <cstdio>
#include <optional>

#include "core/base/result.h"
#include "core/image/extent.h"
#include "core/image/image.h"

namespace etalon {

/// A JPEG file, by libjpeg: bytes of one channel or of three, as sRGB; neither its orientation nor
/// a colour profile is applied. Nothing for a file of other channels (CMYK), which OpenImageIO
/// converts. A failure's reason does not name the file; a file that ends early is one. May throw
/// std::bad_alloc.
std::optional<Result<Image>> read_jpeg(std::FILE* file, Extent extent);

}  // namespace etalon
