#pragma once

#include <variant>

#include "core/image/image.h"
#include "core/image/subsampled_image.h"

namespace etalon {

/// An image in that form which takes least memory. Each has `width`, `height`, `encoding` and
/// color(), and is interpolated by interpolate().
using CompactImage = std::variant<Image, SubsampledImage>;

}  // namespace etalon
