#include "core/numerics/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace etalon {
namespace {

__extension__ typedef unsigned __int128 TwoLimbs;

constexpr int limb_bits = 64;

}  // namespace

WideDouble::operator double() const {
    return std::ldexp(mantissa, exponent);
}

WideDouble operator+(const WideDouble& a, const WideDouble& b) {
    const int exponent = std::max(a.exponent, b.exponent);
    return {std::ldexp(a.mantissa, a.exponent - exponent) +
                std::ldexp(b.mantissa, b.exponent - exponent),
            exponent};
}

WideDouble operator/(const WideDouble& a, const WideDouble& b) {
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
}

WideDouble square_root(const WideDouble& x) {
    const int odd = x.exponent & 1;
    return {std::sqrt(std::ldexp(x.mantissa, odd)), (x.exponent - odd) / 2};
}

/// Makes the mantissa odd, so that integers and their products take few limbs.
Dyadic::Dyadic(double finite) : negative_(finite < 0) {
    if (finite == 0) return;
    constexpr int fraction_bits = 52, least_exponent = -1074;
    constexpr Limb leading_bit = Limb(1) << fraction_bits;
    const auto bits = std::bit_cast<Limb>(finite);
    const int field = static_cast<int>(bits >> fraction_bits) & 2047;  // 0: denormal
    const Limb mantissa = (bits & (leading_bit - 1)) | (field == 0 ? 0 : leading_bit);
    const int zeros = std::countr_zero(mantissa);
    const int exponent = least_exponent + std::max(field, 1) - 1 + zeros;
    const int shift = exponent & (limb_bits - 1);
    const TwoLimbs shifted = TwoLimbs(mantissa >> zeros) << shift;
    low_ = (exponent - shift) / limb_bits;
    limbs_[0] = static_cast<Limb>(shifted);
    limbs_[1] = static_cast<Limb>(shifted >> limb_bits);
    size_ = limbs_[1] == 0 ? 1 : 2;
}

Dyadic& Dyadic::operator=(const Dyadic& other) {
    negative_ = other.negative_;
    low_ = other.low_;
    size_ = other.size_;
    std::copy_n(other.limbs_.data(), size_, limbs_.data());
    return *this;
}

Dyadic Dyadic::operator-() const {
    Dyadic result = *this;
    result.negative_ = !negative_;
    return result;
}

/// Returns the magnitude's leading 64 bits, with a sticky bit for those below, so that the
/// conversion to double rounds correctly.
WideDouble Dyadic::magnitude() const {
    if (size_ == 0) return {};
    const Limb top = limbs_[size_ - 1], next = size_ > 1 ? limbs_[size_ - 2] : 0;
    const int zeros = std::countl_zero(top);
    Limb leading = zeros == 0 ? top : top << zeros | next >> (limb_bits - zeros);
    if (next << zeros != 0 || size_ > 2) leading |= 1;
    return {static_cast<double>(leading), (high() - 1) * limb_bits - zeros};
}

/// Copies a, with zeros around it, and then adds b to it in place.
Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool b_negative) {
    if (b.size_ == 0) return a;
    Dyadic sum;
    if (a.size_ == 0) {
        sum = b;
        sum.negative_ = b_negative;
        return sum;
    }
    sum.negative_ = a.negative_;
    sum.low_ = std::min(a.low_, b.low_);
    sum.size_ = std::max(a.high(), b.high()) - sum.low_ + 1;
    Limb* const limbs = sum.limbs_.data();
    const int first = a.low_ - sum.low_, last = first + a.size_;
    std::fill(limbs, limbs + first, Limb(0));
    std::copy_n(a.limbs_.data(), a.size_, limbs + first);
    std::fill(limbs + last, limbs + sum.size_, Limb(0));
    if (a.negative_ == b_negative) {
        sum.add(b);
    } else {
        sum.subtract(b);
    }
    sum.trim();
    return sum;
}

void Dyadic::add(const Dyadic& other) {
    Limb* limb = limbs_.data() + (other.low_ - low_);
    TwoLimbs carry = 0;
    for (int i = 0; i < other.size_; ++i) {
        carry += TwoLimbs(*limb) + other.limbs_[i];
        *limb++ = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
    for (; carry != 0; ++limb) {
        carry += *limb;
        *limb = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
}

void Dyadic::subtract(const Dyadic& other) {
    Limb* limb = limbs_.data() + (other.low_ - low_);
    Limb borrow = 0;
    for (int i = 0; i < other.size_; ++i) {
        const TwoLimbs difference = TwoLimbs(*limb) - other.limbs_[i] - borrow;
        *limb++ = static_cast<Limb>(difference);
        borrow = static_cast<Limb>(difference >> limb_bits) & 1;
    }
    for (Limb* const end = limbs_.data() + size_; borrow != 0 && limb != end; ++limb) {
        borrow = static_cast<Limb>(*limb == 0);
        --*limb;
    }
    if (borrow != 0) negate();
}

/// Changes the sign, and negates the magnitude in two's complement.
void Dyadic::negate() {
    negative_ = !negative_;
    Limb carry = 1;
    for (int i = 0; i < size_; ++i) {
        limbs_[i] = ~limbs_[i] + carry;
        carry &= static_cast<Limb>(limbs_[i] == 0);
    }
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    if (a.size_ == 0 || b.size_ == 0) return product;
    product.negative_ = a.negative_ != b.negative_;
    product.low_ = a.low_ + b.low_;
    product.size_ = a.size_ + b.size_;
    std::fill_n(product.limbs_.data(), b.size_, Dyadic::Limb(0));
    for (int i = 0; i < a.size_; ++i) {
        Dyadic::Limb carry = 0;
        for (int j = 0; j < b.size_; ++j) {
            const TwoLimbs sum =
                TwoLimbs(a.limbs_[i]) * b.limbs_[j] + product.limbs_[i + j] + carry;
            product.limbs_[i + j] = static_cast<Dyadic::Limb>(sum);
            carry = static_cast<Dyadic::Limb>(sum >> limb_bits);
        }
        product.limbs_[i + b.size_] = carry;
    }
    product.trim();
    return product;
}

void Dyadic::trim() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
    if (size_ == 0 || limbs_[0] != 0) return;
    const auto first = std::find_if(limbs_.begin(), limbs_.end(), [](Limb x) { return x != 0; });
    const auto zeros = static_cast<int>(first - limbs_.begin());
    std::copy_n(first, size_ - zeros, limbs_.begin());
    low_ += zeros;
    size_ -= zeros;
}

}  // namespace etalon
