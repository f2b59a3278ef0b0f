// Reads the most common numbers of files, a few digits and a point, without a loop over the digits.
// To be included for each instruction set, as Highway does.
#if defined(ETALON_SHORT_NUMBER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_SHORT_NUMBER_INL
#undef ETALON_SHORT_NUMBER_INL
#else
#define ETALON_SHORT_NUMBER_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "core/formats/any_number.h"
#include "core/formats/digit_places.h"
#include "core/formats/digits.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using SixteenBytes = hn::FixedTag<std::uint8_t, 16>;

/// Returns number * 10^exponent, for integers below 2^53 and exponents of magnitude up to 22. Both
/// the number and the power are doubles, so that one rounded operation gives the nearest one
/// (Clinger 1990, "How to Read Floating Point Numbers Accurately").
HWY_INLINE double in_one_operation(std::uint64_t number, int exponent) {
    static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const auto exact = static_cast<double>(static_cast<std::int64_t>(number));
    return exponent <= 0 ? exact / powers[-exponent] : exact * powers[exponent];
}

/// Returns one bit for each byte of a mask, the first one lowest.
template <class Mask>
HWY_INLINE std::uint32_t bits_of(const Mask& mask) {
    std::uint8_t bytes[8];
    hn::StoreMaskBits(SixteenBytes(), mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// Number of bytes from the beginning of a number that read_short() may read.
inline constexpr std::ptrdiff_t short_reach = 32;

/// Reads up to three digits of an exponent, where p is at the 'e', and moves past it. Returns 1000
/// if there are more digits, and 0 if there are none, as the 'e' is then no part of the number.
HWY_INLINE int read_exponent(const char*& p) {
    const char* q = p + 1;
    const bool negative = *q == '-';
    q += negative || *q == '+';
    const EightChars digits = load_eight(q);
    const int count = count_digits(digits);
    if (count == 0) return 0;
    p = q + count;
    const int size = count > 3 ? 1000 : static_cast<int>(value_of_digits(digits, count));
    return negative ? -size : size;
}

/// Reads a number of at most 15 digits, in at most 15 characters before its exponent, to the
/// nearest double. Returns its end; null if it is not of that kind, or too large or small.
HWY_INLINE const char* read_short(const char* p, double& value) {
    // The start of the next number depends on one load and on nothing that is computed from digits,
    // so that the processor can work on several numbers at a time. No branch depends on a sign, the
    // place of a point or the number of digits, which would be unpredictable.
    const SixteenBytes tag;
    const hn::FixedTag<std::uint64_t, 2> halves_tag;
    const std::uint32_t sign = *p == '-' || *p == '+';
    const auto chars = hn::LoadU(tag, reinterpret_cast<const std::uint8_t*>(p));
    const auto digits = hn::Sub(chars, hn::Set(tag, '0'));
    const std::uint32_t is_digit = bits_of(hn::Eq(digits, hn::Min(digits, hn::Set(tag, 9))));
    const std::uint32_t is_point = bits_of(hn::Eq(chars, hn::Set(tag, '.')));
    const std::uint32_t point = is_point & (0 - is_point);  // the first
    const int size = std::countr_zero(~(is_digit | point | sign));
    const int point_at = std::countr_zero(point | 1U << size);
    if (size == 16 || (is_digit & ((1U << size) - 1)) == 0) return nullptr;

    const auto places = hn::LoadU(tag, digit_places(static_cast<int>(sign), point_at, size));
    HWY_ALIGN std::uint64_t halves[2];
    hn::Store(hn::BitCast(halves_tag, hn::TableLookupBytesOr0(digits, places)), halves_tag, halves);
    std::uint64_t number = value_of_eight(halves[1]);
    if (halves[0] != 0) number += std::uint64_t{100000000} * value_of_eight(halves[0]);
    const char* end = p + size;
    int exponent = point_at < size ? point_at + 1 - size : 0;
    if ((*end | 0x20) == 'e') {
        exponent += read_exponent(end);
        if (exponent < -22 || exponent > 22) return nullptr;
    }
    const double magnitude = in_one_operation(number, exponent);
    value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) | std::uint64_t{*p == '-'}
                                                                                << 63);
    return end;
}

/// The same to the nearest float. That is the float nearest to the nearest double, unless the
/// double is halfway between two floats: then the digits decide.
HWY_INLINE const char* read_short(const char* p, float& value) {
    double nearest = 0;
    const char* const end = read_short(p, nearest);
    value = static_cast<float>(nearest);
    constexpr std::uint64_t below_float = (1U << 29) - 1, half = 1U << 28;
    const bool is_between = (std::bit_cast<std::uint64_t>(nearest) & below_float) == half;
    const bool is_normal = std::abs(value) >= std::numeric_limits<float>::min() || value == 0;
    return is_between || !is_normal ? nullptr : end;
}

#endif

/// Reads a number; T is float or double.
template <class T>
HWY_INLINE ScannedNumber scan(const char* first, const char* last, T& value) {
#if HWY_TARGET != HWY_SCALAR
    if (last - first >= short_reach) {
        if (const char* const end = read_short(first, value)) return {end, NumberStatus::ok};
    }
#endif
    return scan_any_number(first, last, value);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
