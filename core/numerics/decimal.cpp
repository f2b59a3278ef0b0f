#include "core/numerics/decimal.h"

#include <algorithm>

namespace etalon {
namespace {

constexpr double mantissa_end = 0x1p26;

constexpr std::array<double, 23> make_powers() {
    std::array<double, 23> powers{1};
    for (std::size_t e = 1; e < powers.size(); ++e) powers[e] = 10 * powers[e - 1];
    return powers;
}

constexpr std::array<double, 23> powers = make_powers();

/// The largest e with |x| 10^e below the mantissa's end, or one more.
int exponent_for(double x) {
    if (x == 0) return 0;
    const int binary = 26 - std::ilogb(x);  // 10^e <= 2^binary
    return std::clamp(binary * 77 / 256, 0, static_cast<int>(powers.size()) - 1);
}

}  // namespace

/// A mantissa of as many digits as there is room for: a shorter one times a power of ten is the
/// same number.
std::optional<Decimal> Decimal::from(double x) {
    if (!(std::abs(x) < mantissa_end) || (x == 0 && std::signbit(x))) return std::nullopt;
    int e = exponent_for(x);
    double mantissa = std::nearbyint(x * powers[static_cast<std::size_t>(e)]);
    if (std::abs(mantissa) >= mantissa_end) {
        if (e == 0) return std::nullopt;
        mantissa = std::nearbyint(x * powers[static_cast<std::size_t>(--e)]);
    }
    const Decimal result(static_cast<std::int32_t>(mantissa), e);
    if (result.value() != x) return std::nullopt;
    return result;
}

}  // namespace etalon
