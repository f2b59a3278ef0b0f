#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// Red, green, blue, as sRGB shows them: from black at 0 by violet and orange to a pale yellow at
/// 1, ever brighter. What is outside of [0, 1] is taken to its nearer end.
std::array<std::uint8_t, 3> magma(double value);

/// The same for every pixel, as display_bytes orders them; `white` is what is shown as 1.
std::vector<std::uint8_t> magma(const PixelPlane& plane, double white = 1);

}  // namespace etalon
