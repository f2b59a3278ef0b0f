#pragma once

#include <cstddef>
#include <cstdint>

#include "core/image/image.h"

namespace etalon {

/// Pixels as most JPEG files store them, with 4:2:0 chroma subsampling, in half the memory of RGB:
/// luma (Y) for each, and two samples of chroma (Cb, Cr) for each 2x2 of them, between whose
/// centres chroma is interpolated. Colours are the bytes that libjpeg-turbo gives, by its "fancy
/// upsampling" (jdsample.c) and its conversion in fixed point (jdcolor.c).
struct SubsampledImage {
    static constexpr Encoding encoding = Encoding::srgb;

    int width = 0, height = 0;
    PixelBytes pairs;  ///< of rows of pixels: two rows of Y, one of Cb, one of Cr; whole blocks

    /// Returns the bytes of a row of Y, twice as many as of one of Cb or Cr.
    static std::size_t stride(int width) {
        return (static_cast<std::size_t>(width) + 15) / 16 * 16;
    }
    static std::size_t pair_size(int width) { return 3 * stride(width); }

    int chroma_width() const { return (width + 1) / 2; }
    int chroma_height() const { return (height + 1) / 2; }

    const std::uint8_t* luma(int y) const {
        return &pairs[(y / 2) * pair_size(width) + (y % 2) * stride(width)];
    }
    const std::uint8_t* cb(int row) const {
        return &pairs[row * pair_size(width) + 2 * stride(width)];
    }
    const std::uint8_t* cr(int row) const { return cb(row) + stride(width) / 2; }

    /// Returns the colour of a pixel, with channels divided by 255. 0 <= x < width,
    /// 0 <= y < height.
    Color color(int x, int y) const;
};

/// Factors of JFIF's conversion from YCbCr to RGB, in units of 1/65536.
struct YcbcrFactors {
    static constexpr int red_of_cr = 91881;     ///< 1.402
    static constexpr int green_of_cb = -22554;  ///< 0.34414
    static constexpr int green_of_cr = -46802;  ///< 0.71414
    static constexpr int blue_of_cb = 116130;   ///< 1.772
    static constexpr int half = 1 << 15;
    static constexpr int bits = 16;
};

}  // namespace etalon
