#pragma once

#include <array>
#include <cstdint>

namespace etalon {

/// Shuffle that moves the digits of a number, without its point, to the end of sixteen places.
/// Entry i is the character for place i; 0x80 for the unused places before the digits.
using DigitPlaces = std::array<std::uint8_t, 16>;

/// Returns the shuffle for a number of `end` characters, up to 15. `sign` is whether it begins with
/// a sign; `point_at` is the index of its point, or `end` if it has none.
constexpr DigitPlaces make_digit_places(int sign, int point_at, int end) {
    DigitPlaces places{};
    places.fill(0x80);
    int place = 16;
    for (int i = end - 1; i >= sign; --i) {
        if (i != point_at && place > 0)
            places[static_cast<std::size_t>(--place)] = static_cast<std::uint8_t>(i);
    }
    return places;
}

using DigitPlacesTable = std::array<DigitPlaces, 2 * 16 * 16>;

constexpr DigitPlacesTable make_digit_places_table() {
    DigitPlacesTable table{};
    for (int sign = 0; sign < 2; ++sign) {
        for (int point_at = 0; point_at < 16; ++point_at) {
            for (int end = 0; end < 16; ++end) {
                table[static_cast<std::size_t>((sign * 16 + point_at) * 16 + end)] =
                    make_digit_places(sign, point_at, end);
            }
        }
    }
    return table;
}

alignas(64) inline constexpr DigitPlacesTable digit_places_table = make_digit_places_table();

inline const std::uint8_t* digit_places(int sign, int point_at, int end) {
    return digit_places_table[static_cast<std::size_t>((sign * 16 + point_at) * 16 + end)].data();
}

}  // namespace etalon
