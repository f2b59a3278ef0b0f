#pragma once

#include "core/image/image.h"

namespace etalon {

/// Puts the pixels of an image in rows from the top, each from the left, and swaps its sides if its
/// rows are columns. `orientation` is one of TIFF's and Exif's, 1 to 8; 1, and any other number,
/// changes nothing. The image may be a header alone, without pixels.
void put_upright(Image& image, int orientation);

}  // namespace etalon
