// Images whose sides are no powers of two, as pbrt-v3 shows them: stretched to the next ones.
#pragma once

#include <vector>

#include "core/scene/texture.h"

namespace etalon {

/// Values of the texels of an image by rows, channels interleaved.
struct TexelGrid {
    int width = 0, height = 0, channels = 0;  ///< 1 or 3 channels
    std::vector<float> values;
};

/// Whether both sides are powers of two.
bool has_power_of_two_sides(int width, int height);

/// Stretches an image to the next powers of two on each side. Each texel is the mean of the four
/// nearest ones along an axis, by Lanczos' window of a radius of two texels (Pharr, Jakob and
/// Humphreys 2016, 10.4.3); sums below 0 are 0. `wrap` says what lies beyond a border.
TexelGrid stretched_to_powers_of_two(const TexelGrid& image, Wrap wrap);

}  // namespace etalon
