#include "core/formats/any_number.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace etalon {
namespace {

constexpr std::int64_t most_digits = 19;  // 10^19 < 2^64

bool read_minus(const char*& p, const char* last) {
    if (p == last) return false;
    const bool minus = *p == '-';
    if (minus || *p == '+') ++p;
    return minus;
}

/// Reads digits into `value`, which wraps around if there are more than 19. Returns their number.
std::int64_t read_digits(const char*& p, const char* last, std::uint64_t& value) {
    const char* const first = p;
    for (; p != last; ++p) {
        const unsigned digit = static_cast<unsigned char>(*p) - unsigned{'0'};
        if (digit > 9) break;
        value = value * 10 + digit;
    }
    return p - first;
}

/// Reads the exponent that ends a number; a huge one becomes 10^18, which is far from overflow.
std::int64_t exponent_of(const char* first, const char* last) {
    const char* p = std::find_if(first, last, [](char c) { return (c | 0x20) == 'e'; });
    if (p == last) return 0;
    const bool negative = read_minus(++p, last);
    constexpr std::uint64_t huge = 1'000'000'000'000'000'000;
    std::uint64_t value = 0;
    const std::int64_t count = read_digits(p, last, value);
    const auto size = static_cast<std::int64_t>(count > most_digits ? huge : std::min(value, huge));
    return negative ? -size : size;
}

/// Returns whether an unsigned number that is out of range is too small, not too large: whether its
/// first digit that is not 0 is behind the point once the exponent has moved it.
bool is_tiny(const char* first, const char* last) {
    const char* const point = std::find_if(first, last, [](char c) { return c < '0' || c > '9'; });
    const char* const digit =
        std::find_if(first, last, [](char c) { return c >= '1' && c <= '9'; });
    const std::ptrdiff_t place = digit < point ? point - digit : point - digit + 1;
    return place + exponent_of(first, last) <= 0;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Returns whether [p, last) begins with a digit, possibly after a point.
bool at_digits(const char* p, const char* last) {
    if (p != last && *p == '.') ++p;
    return p != last && is_digit(*p);
}

}  // namespace

template <class T>
ScannedNumber scan_any_number(const char* first, const char* last, T& value) {
    const char* p = first;
    const bool negative = read_minus(p, last);
    if (!at_digits(p, last)) return {p, NumberStatus::malformed};  // from_chars reads more: "inf"
    const auto [end, error] = std::from_chars(p, last, value);
    if (error != std::errc()) {
        if (!is_tiny(p, end)) return {end, NumberStatus::out_of_range};
        value = 0;
    }
    if (negative) value = -value;
    return {end, NumberStatus::ok};
}

template ScannedNumber scan_any_number(const char* first, const char* last, float& value);
template ScannedNumber scan_any_number(const char* first, const char* last, double& value);

}  // namespace etalon
