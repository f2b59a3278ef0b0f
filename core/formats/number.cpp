#include "core/formats/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace etalon {
namespace {

/// A number taken apart: digits * 10^exponent. `digits` has wrapped around if there were too many.
struct Decimal {
    std::uint64_t digits = 0;
    std::int64_t count = 0;  ///< number of digits, leading zeros included
    std::int64_t exponent = 0;
};

constexpr std::int64_t most_digits = 19;  // 10^19 < 2^64

inline bool read_minus(const char*& p, const char* last) {
    if (p == last) return false;
    const bool minus = *p == '-', plus = *p == '+';
    p += minus || plus;  // not a branch: signs cannot be predicted
    return minus;
}

inline std::int64_t read_digits(const char*& p, const char* last, std::uint64_t& value) {
    const char* const first = p;
    for (; p != last; ++p) {
        const unsigned digit = static_cast<unsigned char>(*p) - unsigned{'0'};
        if (digit > 9) break;
        value = value * 10 + digit;
    }
    return p - first;
}

/// Reads the exponent after an 'e'. Without digits it is not an exponent and is left alone.
std::int64_t read_exponent(const char*& p, const char* last) {
    const char* q = p + 1;
    const bool negative = read_minus(q, last);
    std::uint64_t value = 0;
    const std::int64_t count = read_digits(q, last, value);
    if (count == 0) return 0;
    p = q;
    constexpr std::uint64_t huge = 1'000'000'000'000'000'000;  // and still far from overflow
    const auto size = static_cast<std::int64_t>(count > most_digits ? huge : std::min(value, huge));
    return negative ? -size : size;
}

inline Decimal read_decimal(const char*& p, const char* last) {
    Decimal d;
    d.count = read_digits(p, last, d.digits);
    if (p != last && *p == '.') {
        const std::int64_t fraction = read_digits(++p, last, d.digits);
        d.count += fraction;
        d.exponent = -fraction;
    }
    if (d.count > 0 && p != last && (*p | 0x20) == 'e') d.exponent += read_exponent(p, last);
    return d;
}

/// A double holds integers up to 2^53 and powers of ten up to 10^22 exactly, so that one rounded
/// operation on them gives the nearest double (Clinger 1990, "How to Read Floating Point Numbers
/// Accurately").
bool is_one_operation(const Decimal& d) {
    return d.count <= most_digits && d.digits <= (std::uint64_t{1} << 53) && d.exponent >= -22 &&
           d.exponent <= 22;
}

double in_one_operation(const Decimal& d) {
    static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const auto digits = static_cast<double>(d.digits);
    return d.exponent < 0 ? digits / powers[-d.exponent] : digits * powers[d.exponent];
}

/// Whether a number outside the range of double is outside at the lower end.
bool is_tiny(const Decimal& d, const char* first, const char* last) {
    const char* const digit =
        std::find_if(first, last, [](char c) { return c != '0' && c != '.'; });
    const std::int64_t zeros = std::count(first, digit, '0');
    return d.count - zeros + d.exponent < 0;
}

/// The sign is read already. False if no double is near.
bool in_general(const Decimal& d, const char* first, const char* last, double& value) {
    if (std::from_chars(first, last, value).ec == std::errc()) return true;
    value = 0;
    return is_tiny(d, first, last);
}

}  // namespace

ScannedNumber scan_number(const char* first, const char* last, double& value) {
    const char* p = first;
    const bool negative = read_minus(p, last);
    const char* const unsigned_first = p;
    const Decimal d = read_decimal(p, last);
    if (d.count == 0) return {p, NumberStatus::malformed};
    if (is_one_operation(d)) {
        value = in_one_operation(d);
    } else if (!in_general(d, unsigned_first, p, value)) {
        return {p, NumberStatus::out_of_range};
    }
    value = std::copysign(value, negative ? -1.0 : 1.0);
    return {p, NumberStatus::ok};
}

ScannedNumber scan_number(const char* first, const char* last, std::int64_t& value) {
    const char* p = first;
    const bool negative = read_minus(p, last);
    std::uint64_t digits = 0;
    const std::int64_t count = read_digits(p, last, digits);
    if (count == 0) return {p, NumberStatus::malformed};
    if (count > most_digits || digits > std::numeric_limits<std::int64_t>::max()) {
        return {p, NumberStatus::out_of_range};
    }
    value = static_cast<std::int64_t>(digits);
    if (negative) value = -value;
    return {p, NumberStatus::ok};
}

}  // namespace etalon
