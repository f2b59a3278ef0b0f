// Numbers of at most seven or eight digits, as in text files, in 32 bits instead of 64.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace etalon {

/// The double nearest to m 10^-e, |m| < 2^26 and 0 <= e <= 22: the same bits as from parsing the
/// digits. Excludes negative zero.
class Decimal {
  public:
    /// Converts a number; nothing for one that is not of this form.
    static std::optional<Decimal> from(double x);

    /// Returns m times 10^-e, which two doubles hold to 79 bits. The product with the first half is
    /// exact, so the sum rounds as the quotient does, except for quotients within 2^-78 of a tie.
    /// from() compares, and so refuses those.
    double value() const {
        const double m = static_cast<std::int32_t>(bits_) >> 5;
        const InversePower& power = inverse_powers[bits_ & 31];
        return m * power.high + m * power.low;
    }

  private:
    static constexpr int last_power = 22;  ///< 10^22 is the largest that a double holds exactly

    struct InversePower {
        double high, low;  ///< 26 bits, and the 53 after them
    };

    /// Returns a number's upper 26 bits (Veltkamp's splitting).
    static constexpr double upper_half(double x) {
        const double c = 0x1p27 * x + x;
        return c - (c - x);
    }

    static constexpr std::array<InversePower, 32> make_inverse_powers() {
        std::array<InversePower, 32> powers{};
        double p = 1;
        for (int e = 0; e <= last_power; ++e, p *= 10) {
            const double high = upper_half(1 / p), p1 = upper_half(p);
            // 1 - high p, exactly: of two halves each product has at most 53 bits.
            const double rest = (1 - high * p1) - high * (p - p1);
            powers[static_cast<std::size_t>(e)] = {high, rest / p};
        }
        return powers;
    }

    static const std::array<InversePower, 32> inverse_powers;

    Decimal(std::int32_t mantissa, int exponent)
        : bits_(static_cast<std::uint32_t>(mantissa) << 5 | static_cast<std::uint32_t>(exponent)) {}

    std::uint32_t bits_;
};

inline constexpr std::array<Decimal::InversePower, 32> Decimal::inverse_powers =
    Decimal::make_inverse_powers();

}  // namespace etalon
