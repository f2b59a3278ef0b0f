#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// Returns red, green and blue in sRGB of a colour map with increasing brightness: from black at 0
/// by violet and orange to a pale yellow at 1. Values outside of [0, 1] are clamped.
std::array<std::uint8_t, 3> magma(double value);

/// The same for every pixel, in the order of display_bytes; `white` is the value shown as 1.
std::vector<std::uint8_t> magma(const PixelPlane& plane, double white = 1);

}  // namespace etalon
