#pragma once

#include <bit>
#include <cstdint>

namespace etalon {

/// Returns whether two numbers are the same to the bit: 0 and -0 are not, a NaN may be.
inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace etalon
