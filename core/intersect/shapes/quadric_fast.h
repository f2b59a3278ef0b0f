// Fast path for most rays on a quadric, in plain double with a bound on all rounding errors. What
// it leaves uncertain is decided by core/intersect/shapes/quadric_exact.h.
#pragma once

#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/roots.h"
#include "core/scene/quadric_form.h"

namespace etalon {

/// The form A t^2 + 2 B t + C on the ray from where it enters the clip box, so that nothing cancels
/// with distance. A t + B is -root where the form falls, where the front is seen, and +root where
/// it rises.
///
/// The errors, u = 2^-53. The start w is off by less than 2 u (|o - centre| + |start d|) in every
/// coordinate. The sums for A, B and C have terms of at most 9 roundings; their errors are bounded
/// by 10 u times the same sums of magnitudes. The error e of w adds (|M||d|).e to B, and 2 (|M|(|w|
/// + e) + |l|).e to C.
class QuadricFastPath {
  public:
    QuadricFastPath(const Quadric& s, const RayQuery& q)
        : shape_(s),
          ray_(q.ray),
          form_(s.coefficients),
          slabs_(cross_slabs(Box{s.clip.min, s.clip.max}, q.ray)) {}

    /// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain.
    double first_hit(Sides sides) {
        error_bound_of_slabs_ = 4 * u * (std::abs(slabs_.entry) + std::abs(slabs_.exit));
        const double start = std::max(slabs_.entry, ray_.tmin);
        if (slabs_.entry == infinity || start - slabs_.exit > error_bound_of_slabs_) return no_hit;
        start_ = std::max(slabs_.entry, 0.0);
        stretch_ = slabs_.exit - start_ + error_bound_of_slabs_;
        expand();
        if (!is_in_range()) return uncertain;
        const double discriminant = B_ * B_ - A_ * C_;
        const double error_bound = (2 * std::abs(B_) + error_bound_of_B_) * error_bound_of_B_ +
                                   (std::abs(C_) + error_bound_of_C_) * error_bound_of_A_ +
                                   std::abs(A_) * error_bound_of_C_ +
                                   4 * u * (B_ * B_ + std::abs(A_ * C_));
        if (!(error_bound > 0x1p-900)) return uncertain;
        if (discriminant < -error_bound) return no_hit;
        if (!(discriminant > 2 * error_bound)) return uncertain;
        root_ = std::sqrt(discriminant);
        sum_ = std::abs(B_) + root_;
        return first_root(sides);
    }

  private:
    static constexpr double u = unit_roundoff;

    void expand() {
        const Vec3 &o = ray_.origin, &d = ray_.direction, f = o - shape_.centre;
        const Vec3 e = (2.1 * u) * (abs(f) + start_ * abs(d));
        w_ = f + start_ * d;
        const auto line = form_.on_line(w_, d);
        const auto terms =
            QuadricForm<double>(magnitudes_of(shape_.coefficients)).on_line(abs(w_) + e, abs(d));
        A_ = line.A, B_ = line.B, C_ = line.C;
        error_bound_of_A_ = 10 * u * terms.A;
        error_bound_of_B_ = 10 * u * terms.B + terms.Md.dot(e);
        error_bound_of_C_ = 10 * u * terms.C + 2 * terms.slope.dot(e);
        speed_ = max_abs(d);
        reach_ = max_abs(w_) + stretch_ * speed_;
    }

    /// Returns whether relevant underflow, and overflow, are excluded.
    bool is_in_range() const {
        constexpr double least = 0x1p-120, most = 0x1p120;
        return speed_ > least && speed_ < most && reach_ < most && error_bound_of_C_ > 0x1p-460 &&
               is_finite(shape_.clip.min) && is_finite(shape_.clip.max) && !shape_.clip.isEmpty();
    }

    /// Computes a root as a quotient by the sum of like signs. Of two roots ahead, the one that is
    /// a quotient by the sum is the nearer. The true sum is more than 0.35 of the computed one, so
    /// that the other root is known to be far even where A may be zero.
    double first_root(Sides sides) const {
        const int rise = B_ < 0 ? -1 : 1;
        const double t = visible(-rise * C_ / sum_, rise, sides);
        const bool is_far = sum_ > 3 * (std::abs(A_) + error_bound_of_A_) * stretch_;
        if (t <= infinity || is_far) return t;
        return visible(-rise * sum_ / A_, -rise, sides);
    }

    /// The computed t is a root of a form that differs from the true one, there, by at most
    /// error_bound_of_form; half the rise of that form is at least half_rise. So a true root is
    /// within the quotient of the two, if A is small enough for one to exist.
    double visible(double t, int rise, Sides sides) const {
        if (sides == (rise < 0 ? Sides::back : Sides::front)) return no_hit;
        const double length = std::abs(t);
        const double error_bound_of_form =
            (error_bound_of_A_ * length + 2 * error_bound_of_B_) * length + error_bound_of_C_;
        const double half_rise = root_ - (error_bound_of_A_ * length + error_bound_of_B_);
        const bool certain =
            2 * half_rise > root_ &&
            (std::abs(A_) + error_bound_of_A_) * error_bound_of_form <= half_rise * half_rise;
        if (!certain) return uncertain;
        const double roundings = u * length * (2 * sum_ / root_ + 6);
        return clipped(start_ + t, 1.01 * (error_bound_of_form / half_rise) + roundings);
    }

    double clipped(double t, double error_bound) const {
        error_bound += u * std::abs(t);
        const double apart = error_bound + error_bound_of_slabs_;
        const bool is_out =
            t + error_bound < ray_.tmin || t + apart < slabs_.entry || t - apart > slabs_.exit;
        if (is_out) return no_hit;
        const bool certain = t - apart > slabs_.entry && t + apart < slabs_.exit &&
                             error_bound <= t_tolerance / 2 * t;
        if (!certain) return uncertain;
        if (error_bound > 0x1p-44 * t) t = polished(t);
        return t > ray_.tmin ? t : no_hit;
    }

    /// Performs one step of Newton's method: near the point itself, as next to a cone's tip, the
    /// form's terms may be far smaller than where the ray comes from.
    double polished(double t) const {
        const Vec3& d = ray_.direction;
        const auto there = form_.on_line(w_ + (t - start_) * d, d);
        return t - there.C / (2 * there.B);
    }

    const Quadric& shape_;
    const Ray& ray_;
    const QuadricForm<double> form_;
    const SlabCrossing slabs_;
    Vec3 w_;
    double error_bound_of_slabs_, start_, stretch_;
    double A_, B_, C_, error_bound_of_A_, error_bound_of_B_, error_bound_of_C_;
    double speed_, reach_, root_, sum_;
};

}  // namespace etalon
