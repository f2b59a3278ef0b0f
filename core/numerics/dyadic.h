// Exact sums and products of doubles of any range, for decisions that a floating-point filter
// cannot make and whose degree is too high for an Expansion (core/numerics/exact.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace etalon {

/// mantissa 2^exponent: a double whose products stay in range. Zero has the least exponent.
struct WideDouble {
    explicit operator double() const;

    double mantissa = 0;
    int exponent = -(1 << 20);
};

WideDouble operator+(const WideDouble& a, const WideDouble& b);
WideDouble operator/(const WideDouble& a, const WideDouble& b);
WideDouble square_root(const WideDouble& x);

/// An integer times a power of 2^64, in sign and magnitude. It has room for the product of
/// thirty-six differences of any finite doubles, and for sums of such products: nothing is ever
/// allocated, and nothing overflows, underflows or is rounded.
class Dyadic {
  public:
    Dyadic() = default;
    explicit Dyadic(double finite);
    Dyadic(const Dyadic& other) { *this = other; }
    Dyadic& operator=(const Dyadic& other);

    /// Returns -1, 0 or 1.
    int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

    /// Returns the magnitude, correctly rounded.
    WideDouble magnitude() const;

    /// Returns the nearest double: infinite, denormal or zero beyond the range of normal ones.
    double rounded() const { return sign() * static_cast<double>(magnitude()); }

    Dyadic operator-() const;
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.negative_); }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, !b.negative_); }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

  private:
    using Limb = std::uint64_t;

    /// Number of limbs: a difference of doubles reaches from 2^-1088 to 2^1025, 34 limbs.
    static constexpr int capacity = 36 * 34;

    static Dyadic sum(const Dyadic& a, const Dyadic& b, bool b_negative);

    int high() const { return low_ + size_; }
    void add(const Dyadic& other);
    void subtract(const Dyadic& other);
    void negate();
    void trim();

    bool negative_ = false;
    int low_ = 0, size_ = 0;            ///< index of the lowest limb, in units of 64 bits
    std::array<Limb, capacity> limbs_;  ///< limbs by increasing weight; neither end is zero
};

inline Dyadic square(const Dyadic& x) {
    return x * x;
}

}  // namespace etalon
