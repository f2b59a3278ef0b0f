// Exact sums of products of three doubles, by a fixed-point number wide enough for all of them
// (Kulisch's long accumulator). An independent check of expansions, with which it shares no method.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace etalon {

class LongSum {
  public:
    /// Adds x y z. The product's bits must lie within 2^-2000 ... 2^2000.
    void add(double x, double y, double z) {
        const SplitDouble hx(x), hy(y), hz(z);
        for (int i = 0; i < 8; ++i) {
            const Wide product = Wide(hx.part[i & 1]) * hy.part[i >> 1 & 1] * hz.part[i >> 2];
            const int halves = (i & 1) + (i >> 1 & 1) + (i >> 2);
            add_scaled(product, hx.exponent + hy.exponent + hz.exponent + 27 * halves);
        }
    }

    /// Returns -1, 0 or 1.
    int sign() const {
        std::int64_t carry = 0;
        bool zero = true;
        for (const std::int64_t digit : digits_) {
            const std::int64_t sum = digit + carry;
            carry = sum >> 32;
            zero = zero && sum == (carry << 32);
        }
        return carry < 0 ? -1 : zero && carry == 0 ? 0 : 1;
    }

  private:
    __extension__ typedef __int128 Wide;

    /// A number x = (part[0] + 2^27 part[1]) 2^exponent, with the sign in both parts.
    struct SplitDouble {
        explicit SplitDouble(double x) {
            const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
            exponent -= 53;
            const auto integer = static_cast<std::int64_t>(mantissa);
            part = {integer % (1 << 27), integer / (1 << 27)};
        }
        std::array<std::int64_t, 2> part;
        int exponent;
    };

    void add_scaled(Wide value, int exponent) {
        const int shift = exponent + 2016;
        for (std::size_t digit = static_cast<std::size_t>(shift / 32); value != 0; ++digit) {
            // The first digit takes the bits above its own shift; later ones 32 bits each.
            const Wide low = value % (Wide(1) << 32);
            add_digits(digit, static_cast<std::int64_t>(low), shift % 32);
            value = (value - low) >> 32;
        }
    }

    void add_digits(std::size_t digit, std::int64_t value, int shift) {
        const Wide shifted = Wide(value) << shift;
        const Wide low = shifted % (Wide(1) << 32);
        digits_[digit] += static_cast<std::int64_t>(low);
        digits_[digit + 1] += static_cast<std::int64_t>((shifted - low) >> 32);
    }

    std::array<std::int64_t, 130> digits_{};  ///< base 2^32, unnormalised, from 2^-2016 up
};

}  // namespace etalon
