#pragma once

#include "core/intersect/shapes/local_line.h"

namespace etalon {

/// Coefficient of a form on a line, with a bound on its error.
using Coefficient = Approximate;

/// The roots of A t^2 + 2 B t + C, whose coefficients are known up to their errors. A t + B is
/// -root at a zero where the form falls, and +root at one where it rises.
class ApproximateRoots {
  public:
    ApproximateRoots(const Coefficient& a, const Coefficient& b, const Coefficient& c)
        : A_(a), B_(b), C_(c) {
        discriminant_ = B_.value * B_.value - A_.value * C_.value;
        const double inherited = (2 * std::abs(B_.value) + B_.error) * B_.error +
                                 (std::abs(C_.value) + C_.error) * A_.error +
                                 std::abs(A_.value) * C_.error;
        const double roundings = 4 * u * (B_.value * B_.value + std::abs(A_.value * C_.value));
        error_ = 1.01 * (inherited + roundings);
    }

    bool misses() const { return in_range() && discriminant_ < -error_; }

    /// Returns whether there are roots and the error of the discriminant is below half of it.
    bool is_certain() const { return in_range() && discriminant_ > 2 * error_; }

    /// Computes the root of the discriminant. Only for roots that are certain.
    void solve() {
        root_ = std::sqrt(discriminant_);
        sum_ = std::abs(B_.value) + root_;
    }

    /// Returns the slope of the form at the root that is a quotient by a sum of like signs: -1 if
    /// it falls, else 1.
    int near_way() const { return B_.value < 0 ? -1 : 1; }

    /// Returns whether the other root is certainly further away than `stretch`, or at infinity: the
    /// true sum is more than 0.35 of the computed one.
    bool has_one_within(double stretch) const {
        return sum_ > 3 * (std::abs(A_.value) + A_.error) * stretch;
    }
    /// Returns whether the sign of A, and so the order of the roots, is known.
    bool has_two() const { return std::abs(A_.value) > A_.error; }

    Approximate near() const { return bounded(-near_way() * C_.value / sum_); }
    Approximate far() const { return bounded(-near_way() * sum_ / A_.value); }

  private:
    static constexpr double u = unit_roundoff;

    bool in_range() const { return error_ > 0x1p-900 && error_ < 0x1p900; }

    /// Returns t with a bound on its error. The computed t is a root of a form that differs from
    /// the true one, there, by at most `of_form`; half the rise of that form is at least half_rise.
    /// So a true root is within the quotient of the two, if A is small enough for one to exist.
    Approximate bounded(double t) const {
        const double length = std::abs(t);
        const double of_form = (A_.error * length + 2 * B_.error) * length + C_.error;
        const double half_rise = root_ - (A_.error * length + B_.error);
        const bool certain = 2 * half_rise > root_ &&
                             (std::abs(A_.value) + A_.error) * of_form <= half_rise * half_rise;
        if (!certain) return {t, infinity};
        return {t, 1.01 * (of_form / half_rise) + u * length * (2 * sum_ / root_ + 6)};
    }

    Coefficient A_, B_, C_;
    double discriminant_, error_;
    double root_ = 0, sum_ = 0;
};

}  // namespace etalon
