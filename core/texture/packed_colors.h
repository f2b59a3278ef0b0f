#pragma once

#include <array>
#include <cstdint>

#include "core/numerics/vec.h"
#include "core/parallel/large_pages.h"

namespace etalon {

/// A colour in 32 bits: eleven each for the square roots of red and of green, ten for that of blue.
/// Steps are smaller than those of a file's bytes, whether encoded by sRGB's curve or not.
using PackedColor = std::uint32_t;

/// The position of a channel in the word, and the root of 1, whose square is exact. The largest
/// value is 1.266; stretching gives up to 81/64.
struct PackedChannel {
    int shift;
    PackedColor largest;
    float one;
};

inline constexpr std::array<PackedChannel, 3> packed_channels = {
    {{0, 2047, 1819}, {11, 2047, 1819}, {22, 1023, 909}}};

/// Packs channels not below 0; larger ones than can be represented are clamped.
PackedColor packed(const Color& color);

inline Color unpacked(PackedColor color) {
    const auto channel = [&](int k) {
        const auto& [shift, largest, one] = packed_channels[k];
        const auto root = static_cast<float>(static_cast<int>(color >> shift & largest));
        return root * root * (1 / (one * one));
    };
    return {channel(0), channel(1), channel(2)};
}

/// Packed colours in rows from the top.
struct PackedImage {
    int width = 0, height = 0;
    LargeVector<PackedColor> texels;
};

}  // namespace etalon
