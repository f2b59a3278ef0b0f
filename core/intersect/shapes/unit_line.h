#pragma once

#include "core/intersect/shapes/local_line.h"

namespace etalon {

/// The line w + t d and the unit sphere about the origin or, where z is 0, the unit circle: |w + t
/// d|^2 - 1 = A t^2 + 2 B t + C. By Lagrange's identity the discriminant is |d|^2 - |m|^2 for m = w
/// x d. It does not cancel with distance, for m / |d| is how far the line passes from the centre.
///
/// Products of two vectors that are off by e and f are off by |a| f + |b| e + e f (Cauchy and
/// Schwarz), and their own roundings are in e_d, see LocalLine. The square of m is off by
/// e_m (2 |m| + e_m), for e_m = e_B, and by less than that again from its roundings.
class UnitLine {
  public:
    UnitLine(const Vec3& w, double e_w, const Vec3& d, double e_d)
        : A_(d.dot(d)), B_(w.dot(d)), C_(w.dot(w) - 1), e_w_(e_w), speed_(sum_abs(d) + e_d) {
        const Vec3 m = w.cross(d);
        const double far = sum_abs(w), fast = sum_abs(d);
        discriminant_ = A_ - m.dot(m);
        e_A_ = e_d * (2 * fast + e_d);
        e_B_ = e_w * fast + e_d * (far + e_w);
        e_C_ = e_w * (2 * far + e_w) + 4 * unit_roundoff * (std::abs(C_) + 2);
        e_discriminant_ = e_A_ + e_B_ * (4 * sum_abs(m) + e_B_);
    }

    /// Returns whether the line starts outside and moves away.
    bool leaves() const { return C_ > e_C_ && B_ > e_B_; }

    bool misses() const { return discriminant_ < -e_discriminant_; }
    bool is_certain() const { return discriminant_ > e_discriminant_; }

    /// Returns whether not even the magnitude of A is known, as for a line along the cylinder.
    bool is_parallel() const { return !(A_ > 8 * e_A_); }

    /// Returns whether the points up to t = +-longest are all inside or all outside.
    bool stays_clear(double longest) const {
        const double radius = std::sqrt(C_ + 1);
        const double drift = speed_ * longest + e_w_ + 4 * unit_roundoff * (1 + radius);
        return std::abs(radius - 1) > 1.01 * drift;
    }
    bool starts_inside() const { return C_ < 0; }

    /// Computes the interval by the sum of like signs, in which nothing cancels.
    LineInterval interval() const {
        const double root = std::sqrt(discriminant_), sum = std::abs(B_) + root;
        const double per_sum = 1 / sum, per_A = 1 / A_;
        const double off = (e_B_ + e_discriminant_ / root) * per_sum + 4 * unit_roundoff;
        const double off_A = e_A_ * per_A;
        // First-order terms. The higher ones add less than a quarter of them.
        const double more = std::max(off, off_A) < 0.1 ? 1.25 : infinity;
        const double far = sum * per_A, near = C_ * per_sum;
        const double e_far = more * (off + off_A) * far;
        const double e_near = more * (off * std::abs(near) + e_C_ * per_sum);
        if (B_ < 0) return {{near, e_near}, {far, e_far}};
        return {{-far, e_far}, {-near, e_near}};
    }

  private:
    double A_, B_, C_, discriminant_;
    double e_A_, e_B_, e_C_, e_discriminant_;
    double e_w_, speed_;
};

}  // namespace etalon
