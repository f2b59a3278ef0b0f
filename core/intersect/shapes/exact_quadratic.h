#pragma once

#include "core/numerics/dyadic.h"

namespace etalon {

/// A t^2 + 2 B t + C in exact arithmetic. Decides without a rounding whether a line and a quadric
/// meet, and in which order a root and a plane come. The form rises along the line by 2 (A t + B),
/// which is -2 root at one of its zeros, `in`, and +2 root at the other, `out`.
class ExactQuadratic {
  public:
    static constexpr int in = -1, out = 1;

    ExactQuadratic(const Dyadic& a, const Dyadic& b, const Dyadic& c);

    /// Returns whether the form has roots and is not constant.
    bool has_roots() const {
        return discriminant_.sign() >= 0 && (a_.sign() != 0 || b_.sign() != 0);
    }

    /// Returns the sign of A, which is that of the form at infinity.
    int opening() const { return a_.sign(); }

    /// Returns a root, good to a few roundings. NaN or infinite where A vanishes and with it this
    /// root.
    double root(int way) const;

    /// Returns the sign of start + rise t at a root.
    int sign_at_root(int way, const Dyadic& start, const Dyadic& rise) const;

    /// Returns the sign of a t^2 + b t + c at a root.
    int sign_at_root(int way, const Dyadic& a, const Dyadic& b, const Dyadic& c) const;

  private:
    Dyadic a_, b_, c_, discriminant_;
};

}  // namespace etalon
