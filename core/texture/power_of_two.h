// Resampling of images to sides that are powers of two, as in pbrt-v3.
#pragma once

#include <bit>
#include <functional>
#include <span>

#include "core/scene/texture.h"

namespace etalon {

/// Texels of an image, produced row by row on demand, from the top, with interleaved channels.
struct TexelRows {
    int width = 0, height = 0, channels = 0;         ///< 1 or 3 channels
    std::function<void(int y, float* texels)> read;  ///< writes row `y`, on any thread
};

/// Returns whether both sides are powers of two.
bool has_power_of_two_sides(int width, int height);

/// Returns the length to which a side is stretched.
inline int next_power_of_two(int length) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(length)));
}

/// Receives row `y` of an image.
using RowUser = std::function<void(int y, std::span<const float> texels)>;

/// Stretches an image to the next powers of two on each side, and passes each row to `use` once, on
/// any thread. Each texel is a weighted mean of the four nearest ones along an axis, by Lanczos'
/// window of a radius of two texels (Pharr, Jakob and Humphreys 2016, 10.4.3); sums below 0 are set
/// to 0. `wrap` says what lies beyond a border.
void stretch_to_powers_of_two(const TexelRows& image, Wrap wrap, const RowUser& use);

/// The same, but an image whose sides are powers of two is passed unchanged.
void for_each_stretched_row(const TexelRows& image, Wrap wrap, const RowUser& use);

}  // namespace etalon
