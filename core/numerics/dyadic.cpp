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

Dyadic::Dyadic(double finite) : negative_(finite < 0) {
    if (finite == 0) return;
    int exponent;
    const double fraction = std::frexp(std::abs(finite), &exponent);
    const auto mantissa = static_cast<Limb>(std::ldexp(fraction, 53));
    exponent -= 53;
    const int shift = exponent & (limb_bits - 1);
    low_ = (exponent - shift) / limb_bits;
    size_ = 2;
    const TwoLimbs shifted = TwoLimbs(mantissa) << shift;
    limbs_[0] = static_cast<Limb>(shifted);
    limbs_[1] = static_cast<Limb>(shifted >> limb_bits);
    trim();
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

/// The magnitude's leading 64 bits, with what is below them in the last one, so that the
/// conversion to double rounds as if it saw all.
WideDouble Dyadic::magnitude() const {
    if (size_ == 0) return {};
    const Limb top = limb(high() - 1), next = limb(high() - 2);
    const int zeros = std::countl_zero(top);
    Limb leading = zeros == 0 ? top : top << zeros | next >> (limb_bits - zeros);
    if (next << zeros != 0 || size_ > 2) leading |= 1;
    return {static_cast<double>(leading), (high() - 1) * limb_bits - zeros};
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.size_ == 0) return b;
    if (b.size_ == 0) return a;
    Dyadic sum;
    const int low = std::min(a.low_, b.low_);
    sum.reserve(low, std::max(a.high(), b.high()) - low + 1);
    if (a.negative_ == b.negative_) {
        sum.add_magnitudes(a, b);
    } else {
        sum.subtract_magnitudes(a, b);
    }
    sum.trim();
    return sum;
}

void Dyadic::add_magnitudes(const Dyadic& a, const Dyadic& b) {
    negative_ = a.negative_;
    TwoLimbs carry = 0;
    for (int i = 0; i < size_; ++i) {
        carry += TwoLimbs(a.limb(low_ + i)) + b.limb(low_ + i);
        limbs_[i] = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
}

/// In two's complement, from which a negative difference is then taken back.
void Dyadic::subtract_magnitudes(const Dyadic& a, const Dyadic& b) {
    Limb borrow = 0;
    for (int i = 0; i < size_; ++i) {
        const TwoLimbs difference = TwoLimbs(a.limb(low_ + i)) - b.limb(low_ + i) - borrow;
        limbs_[i] = static_cast<Limb>(difference);
        borrow = static_cast<Limb>(difference >> limb_bits) & 1;
    }
    negative_ = a.negative_ != (borrow != 0);
    Limb carry = borrow;
    for (int i = 0; i < size_ && borrow != 0; ++i) {
        limbs_[i] = ~limbs_[i] + carry;
        carry &= static_cast<Limb>(limbs_[i] == 0);
    }
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    if (a.size_ == 0 || b.size_ == 0) return product;
    product.negative_ = a.negative_ != b.negative_;
    product.reserve(a.low_ + b.low_, a.size_ + b.size_);
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

Dyadic::Limb Dyadic::limb(int place) const {
    const int i = place - low_;
    return i >= 0 && i < size_ ? limbs_[i] : 0;
}

void Dyadic::reserve(int low, int size) {
    low_ = low;
    size_ = size;
    std::fill_n(limbs_.data(), size, Limb(0));
}

void Dyadic::trim() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
    int zeros = 0;
    while (zeros < size_ && limbs_[zeros] == 0) ++zeros;
    std::copy(limbs_.data() + zeros, limbs_.data() + size_, limbs_.data());
    low_ += zeros;
    size_ -= zeros;
}

}  // namespace etalon
