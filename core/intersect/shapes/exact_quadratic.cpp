#include "core/intersect/shapes/exact_quadratic.h"

namespace etalon {

ExactQuadratic::ExactQuadratic(const Dyadic& a, const Dyadic& b, const Dyadic& c)
    : a_(a), b_(b), c_(c), discriminant_(square(b) - a * c) {}

/// Computes a root by the sum of like signs.
double ExactQuadratic::root(int way) const {
    const WideDouble a = a_.magnitude(), b = b_.magnitude(), c = c_.magnitude();
    const auto quotient = [](int sign, const WideDouble& x, const WideDouble& y) {
        return sign * static_cast<double>(x / y);
    };
    const WideDouble sum = b + square_root(discriminant_.magnitude());
    if (way * b_.sign() > 0) return quotient(-way * c_.sign(), c, sum);
    return quotient(way * a_.sign(), sum, a);
}

/// Returns the sign of start + rise t at a root. At its zero T = -start / rise let the form be p
/// and half its rise s, both times the square of `rise`. From T to the root it is -way p / (|s| +
/// root) where way s is positive, and way (|s| + root) / A elsewhere.
int ExactQuadratic::sign_at_root(int way, const Dyadic& start, const Dyadic& rise) const {
    if (rise.sign() == 0) return start.sign();
    const Dyadic slope = b_ * rise - a_ * start;  // half of the form's, times `rise`
    const int s = way * slope.sign() * rise.sign();
    if (s > 0) {
        const Dyadic p = a_ * square(start) + rise * (c_ * rise - (b_ + b_) * start);
        return -way * p.sign() * rise.sign();
    }
    const bool tangent = s == 0 && discriminant_.sign() == 0;
    return tangent ? 0 : way * a_.sign() * rise.sign();
}

/// The form itself is zero at the root, so the multiple of it that cancels the square is
/// subtracted. A form without a square is zero at t = -C / 2B.
int ExactQuadratic::sign_at_root(int way, const Dyadic& a, const Dyadic& b, const Dyadic& c) const {
    if (a.sign() == 0) return sign_at_root(way, c, b);
    if (a_.sign() != 0) {
        return a_.sign() * sign_at_root(way, a_ * c - a * c_, a_ * b - (a + a) * b_);
    }
    const Dyadic twice_b = b_ + b_;
    return (a * square(c_) - twice_b * (b * c_ - c * twice_b)).sign();
}

}  // namespace etalon
