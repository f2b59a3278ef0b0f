// Decimal digits eight at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace etalon {

/// Eight characters, the first in the lowest byte.
using EightChars = std::uint64_t;

inline EightChars load_eight(const char* p) {
    EightChars chars;
    std::memcpy(&chars, p, sizeof chars);
    if constexpr (std::endian::native == std::endian::big) chars = __builtin_bswap64(chars);
    return chars;
}

/// Returns the value of eight digits, each a byte from 0 to 9 or the character for it.
inline std::uint32_t value_of_eight(EightChars digits) {
    digits = (digits & 0x0F0F0F0F0F0F0F0F) * (10 * 0x100 + 1) >> 8;  // in pairs 10 a + b
    digits = (digits & 0x00FF00FF00FF00FF) * (100 * 0x10000 + 1) >> 16;
    digits = (digits & 0x0000FFFF0000FFFF) * (10000 * 0x100000000 + 1) >> 32;
    return static_cast<std::uint32_t>(digits);
}

/// Returns the number of digits before the first other character, 0 to 8.
inline int count_digits(EightChars chars) {
    // Both terms of a digit are below 0x80. What a sum carries can only disturb later characters.
    constexpr std::uint64_t from_nine = 0x4646464646464646, zeros = 0x3030303030303030;
    const std::uint64_t others = ((chars + from_nine) | (chars - zeros)) & 0x8080808080808080;
    return std::countr_zero(others) / 8;
}

/// Returns the value of the first `count` characters, 1 to 8, which must be digits.
inline std::uint32_t value_of_digits(EightChars chars, int count) {
    return value_of_eight(chars << (64 - 8 * count));  // puts their last at the last of eight
}

}  // namespace etalon
