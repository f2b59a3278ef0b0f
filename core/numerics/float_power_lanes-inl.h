// Powers of several doubles, rounded to float.
#if defined(ETALON_FLOAT_POWER_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_FLOAT_POWER_LANES_INL_H
#undef ETALON_FLOAT_POWER_LANES_INL_H
#else
#define ETALON_FLOAT_POWER_LANES_INL_H
#endif

#include <array>
#include <numbers>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

using Int64Tag = hn::RebindToSigned<DoubleTag>;

/// Returns c[0] + c[1] x + c[2] x^2 + ..., by Horner's rule for the even and the odd powers, which
/// do not wait for each other.
template <std::size_t count>
HWY_INLINE Doubles polynomial(const std::array<double, count>& c, Doubles x) {
    static_assert(count % 2 == 0);
    const Doubles x2 = x * x;
    Doubles even = broadcast(c[count - 2]), odd = broadcast(c[count - 1]);
    for (std::size_t i = count - 2; i > 0; i -= 2) {
        even = hn::MulAdd(even, x2, broadcast(c[i - 2]));
        odd = hn::MulAdd(odd, x2, broadcast(c[i - 1]));
    }
    return hn::MulAdd(odd, x, even);
}

/// Returns log2 of normal numbers above 0, with a relative error below 2^-44.
///
/// x = 2^e m with m in [sqrt(1/2), sqrt(2)), and log2 m = 2 artanh(z) / ln 2 with z = (m - 1) / (m
/// + 1): a series in z^2 <= 0.0295, of which the first term left out is 2^-44.7 of the sum.
HWY_INLINE Doubles approximate_log2(Doubles x) {
    constexpr std::int64_t one_bits = 0x3ff0000000000000, sqrt_half_bits = 0x3fe6a09e667f3bcd;
    static constexpr std::array<double, 8> artanh{1,       1.0 / 3,  1.0 / 5,  1.0 / 7,
                                                  1.0 / 9, 1.0 / 11, 1.0 / 13, 1.0 / 15};
    const Int64Tag ints;
    const auto bits = hn::BitCast(ints, x);
    const auto exponent =
        hn::ShiftRight<52>(hn::BitCast(hn::RebindToUnsigned<DoubleTag>(),
                                       hn::Add(bits, hn::Set(ints, one_bits - sqrt_half_bits))));
    const auto shift = hn::BitCast(ints, hn::ShiftLeft<52>(exponent));
    const Doubles m =
        hn::BitCast(DoubleTag(), hn::Add(hn::Sub(bits, shift), hn::Set(ints, one_bits)));
    // The exponent as the last bits of 2^52 + exponent, from which it is a double in one step.
    const auto biased = hn::Or(hn::BitCast(ints, exponent), hn::Set(ints, 0x4330000000000000));
    const Doubles e = hn::BitCast(DoubleTag(), biased) - broadcast(0x1p52 + 1023);
    const Doubles z = (m - broadcast(1)) / (m + broadcast(1));
    return e + broadcast(2 / std::numbers::ln2) * z * polynomial(artanh, z * z);
}

/// Returns 2^y for -1000 <= y <= 1000, with a relative error below 2^-41: the power of an integer,
/// and of a rest of at most 1/2 by the series of exp, of which the first term left out is 2^-47.
HWY_INLINE Doubles approximate_exp2(Doubles y) {
    static constexpr std::array<double, 12> exp{
        1,         1,          1.0 / 2,     1.0 / 6,      1.0 / 24,      1.0 / 120,
        1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800};
    const Int64Tag ints;
    const Doubles integer = hn::Round(y);
    const Doubles part = polynomial(exp, (y - integer) * broadcast(std::numbers::ln2));
    const auto shift = hn::ShiftLeft<52>(hn::BitCast(ints, integer + broadcast(0x1.8p52)));
    return hn::BitCast(DoubleTag(), hn::Add(hn::BitCast(ints, part), shift));
}

/// Powers rounded to float, as doubles, where it is certain what they are.
struct FloatPowers {
    Doubles values;
    DoubleMask certain;
};

/// Returns float(x^n), n > 0, or 0 where x is not above 0, with the bits that any pow() gives whose
/// relative error is below 2^-37: what the errors here, below 2^-37 for results that are not 0,
/// leave uncertain is marked. That is a lane in 500.
HWY_INLINE FloatPowers float_powers(Doubles x, double n) {
    const DoubleTag tag;
    const hn::Rebind<float, DoubleTag> floats;
    const Doubles zero = broadcast(0);
    const Doubles y = broadcast(n) * approximate_log2(x);
    const DoubleMask in_range =
        hn::And(x > broadcast(0x1p-1000), hn::And(y > broadcast(-125), y < broadcast(100)));
    const Doubles power = approximate_exp2(hn::IfThenElse(in_range, y, zero));
    const auto rounded = [&](double factor) HWY_ATTR {
        return hn::PromoteTo(tag, hn::DemoteTo(floats, broadcast(factor) * power));
    };
    const Doubles value = rounded(1 - 0x1p-36);
    const DoubleMask is_one_float = value == rounded(1 + 0x1p-36);
    // Half of the least float is 2^-150.
    const DoubleMask is_zero =
        hn::Or(hn::Not(x > zero), hn::And(x > broadcast(0x1p-1000), y < broadcast(-151)));
    return {hn::IfThenElse(is_zero, zero, value), hn::Or(is_zero, hn::And(in_range, is_one_float))};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
