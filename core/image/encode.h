// Conversion of scene values to the bytes of an 8-bit image.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/rendered_image.h"

namespace etalon {

/// Returns the byte that displays the linear value `gain * value`: sRGB's curve (IEC 61966-2-1),
/// rounded to nearest. Values outside of [0, 1] are clamped; NaN is black.
std::uint8_t srgb_byte(float value, double gain = 1);

/// Returns the byte of a display value as the programs that define such images compute it: no
/// curve, 255.99 times the value, truncated. Values outside of [0, 1] are clamped; NaN is black.
/// The gain is that of the light for which the value stands.
std::uint8_t display_byte(float value, double gain = 1);

/// Returns R, G, B of each pixel of the image's window. `exposure` is in stops.
std::vector<std::uint8_t> display_bytes(const RenderedImage& image, double exposure);

}  // namespace etalon
