#include "core/numerics/decimal.h"

#include <algorithm>
#include <bit>

namespace etalon {
namespace {

constexpr double mantissa_end = 0x1p26;

constexpr std::array<double, 23> make_powers() {
    std::array<double, 23> powers{1};
    for (std::size_t e = 1; e < powers.size(); ++e) powers[e] = 10 * powers[e - 1];
    return powers;
}

constexpr std::array<double, 23> powers = make_powers();

/// Returns the largest e with |x| 10^e below the mantissa's end, or one more.
int exponent_for(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int exponent = static_cast<int>(bits >> 52 & 0x7FF) - 1023;  // 2^exponent <= |x|
    return std::clamp((26 - exponent) * 77 / 256, 0, static_cast<int>(powers.size()) - 1);
}

/// Returns the nearest integer, for |x| < 2^51: adding and subtracting `magic` rounds the fraction.
double rounded(double x) {
    constexpr double magic = 0x1.8p52;
    return (x + magic) - magic;
}

}  // namespace

/// Chooses a mantissa of as many digits as there is room for: a shorter one times a power of ten is
/// the same number.
std::optional<Decimal> Decimal::from(double x) {
    if (!(std::abs(x) < mantissa_end) || (x == 0 && std::signbit(x))) return std::nullopt;
    int e = exponent_for(x);
    double mantissa = rounded(x * powers[static_cast<std::size_t>(e)]);
    if (std::abs(mantissa) >= mantissa_end) {
        if (e == 0) return std::nullopt;
        mantissa = rounded(x * powers[static_cast<std::size_t>(--e)]);
    }
    const Decimal result(static_cast<std::int32_t>(mantissa), e);
    if (result.value() != x) return std::nullopt;
    return result;
}

}  // namespace etalon
