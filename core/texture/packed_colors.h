#pragma once

#include <array>
#include <cstdint>

#include "core/numerics/vec.h"
#include "core/parallel/large_pages.h"

namespace etalon {

/// A colour in 32 bits: ten for each channel and two for a unit that they share, after Ward 1991,
/// "Real Pixels". Channels are off by up to 1/1024 of the largest, or by 2^-13 where all are dark:
/// less than half a step of a byte in sRGB.
using PackedColor = std::uint32_t;

inline constexpr int packed_bits = 10;

/// The units, small ones first.
inline constexpr std::array packed_units = {0x1p-12F, 0x1p-11F, 0x1p-10F, 0x1p-9F};

/// Packs channels of 0 to 2; those above are as bright as can be.
PackedColor packed(const Color& color);

inline Color unpacked(PackedColor color) {
    constexpr PackedColor mask = (1U << packed_bits) - 1;
    const float unit = packed_units[color >> (3 * packed_bits)];
    const auto channel = [&](int k) {
        return static_cast<float>(color >> (k * packed_bits) & mask) * unit;
    };
    return {channel(0), channel(1), channel(2)};
}

/// Colours by rows from the top.
struct PackedImage {
    int width = 0, height = 0;
    LargeVector<PackedColor> texels;
};

}  // namespace etalon
