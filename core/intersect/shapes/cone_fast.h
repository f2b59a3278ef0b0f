// Fast path for most rays on a cone, at about the cost of a textbook formula. What it leaves
// uncertain is decided by core/intersect/shapes/cone_bounds_check.h.
#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/roots.h"
#include "core/numerics/rounding.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Constants of error bounds on the form |F + t G|^2 - hh (radius + t growth)^2 = A t^2 + 2 B t +
/// C, of the origin w seen from the base, F = w x h and G = d x h. The base's radius is r, the
/// top's r + s. By Lagrange's identity its discriminant is hh (VV - mm) for m = w.G and V = r G + s
/// (d x w + m h / hh): it does not cancel with distance, for m / |G| is how far the line passes
/// from the axis.
///
/// The error, u = 2^-53: w, h and s are off by u, and a cross or dot product adds less than 3 u of
/// its factors. Let scale = hh + ss, far^2 = ww + rr and size = sqrt(scale) |d| far. By Cauchy and
/// Schwarz V and m are less than size, and off by less than 28 u and 8 u of it; VV - mm is off by
/// less than 96 u size max(|V|, |m|), if it is more than that. A, B and C are off by less than 52 u
/// scale times dd, |d| far and far^2. A height of a point is off by t's error, by 5 u of |w| |h|
/// and |t d| |h|, and by 6 u hh; the square of a sum of four is at most four times the sum of the
/// squares. Beyond the limits underflow that matters, and overflow, cannot be excluded.
struct ConeBounds {
    static constexpr double of_difference = 96 * unit_roundoff;
    static constexpr double of_form = 52 * unit_roundoff;
    static constexpr double of_height = 16 * unit_roundoff;
    /// Shares of t's error from the sum of B and the root, and from A or C: together half of
    /// t_tolerance.
    static constexpr double of_sum = t_tolerance / 16, of_rest = t_tolerance / 4;

    static constexpr double least_error2 = 0x1p-1000;  ///< of VV - mm
    static constexpr double least_size2 = 0x1p-250;    ///< of hh, dd and far^2
    static constexpr double least_product = 0x1p-750, largest_product = 0x1p1000;
};

class ConeFastPath {
  public:
    ConeFastPath(const Cone& c, const RayQuery& q)
        : cone_(c),
          w_(q.ray.origin - c.base),
          d_(q.ray.direction),
          h_(c.top - c.base),
          tmin_(q.ray.tmin),
          spread_(c.top_radius - c.base_radius),
          hh_(h_.dot(h_)),
          dd_(d_.dot(d_)),
          far2_(w_.dot(w_) + c.base_radius * c.base_radius),
          scale_(hh_ + spread_ * spread_),
          slope_(spread_ / hh_),
          G_(d_.cross(h_)) {}

    /// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain.
    double first_hit(Sides sides) {
        const double m = w_.dot(G_), size2 = dd_ * scale_ * far2_;
        Vec3 V = cone_.base_radius * G_;  // all there is for a cylinder, to the bit
        if (spread_ != 0) V += spread_ * d_.cross(w_) + (slope_ * m) * h_;
        const double V2 = V.dot(V), m2 = m * m, difference = V2 - m2;
        const double error_bound2 =
            ConeBounds::of_difference * ConeBounds::of_difference * size2 * std::max(V2, m2);
        const bool certain =
            difference * difference > error_bound2 && error_bound2 > ConeBounds::least_error2;
        if (!(certain && is_in_range(size2))) return uncertain;
        if (difference < 0) return no_hit;
        return first_crossing(sides, hh_ * difference, hh_ * (error_bound2 / difference));
    }

  private:
    static constexpr int in = -1, out = 1;

    /// Returns whether relevant underflow, and overflow, are excluded.
    bool is_in_range(double size2) const {
        const double least = std::min(std::min(hh_, dd_), far2_), most = scale_ * size2;
        return least > ConeBounds::least_size2 && most > ConeBounds::least_product &&
               most < ConeBounds::largest_product &&
               std::min(cone_.base_radius, cone_.top_radius) >= 0;
    }

    /// `root_error_bound2` is the square of a bound on the error of the discriminant's root.
    double first_crossing(Sides sides, double discriminant, double root_error_bound2) {
        expand();
        const double error_bound2 = unit_ * unit_ * (dd_ * far2_);  // of B
        const bool leaves =
            B_ > 0 && A_ > unit_ * dd_ && C_ > unit_ * far2_ && B_ * B_ > error_bound2;
        if (leaves) return no_hit;
        sum_ = std::abs(B_) + std::sqrt(discriminant);
        if (!(root_error_bound2 + error_bound2 <=
              ConeBounds::of_sum * ConeBounds::of_sum * (sum_ * sum_)))
            return uncertain;
        const double t = sides == Sides::back ? no_hit : crossing(in);
        return t <= infinity || sides == Sides::front ? t : crossing(out);
    }

    void expand() {
        const Vec3 F = w_.cross(h_);
        start_ = w_.dot(h_);
        rise_ = d_.dot(h_);
        const double radius = cone_.base_radius + slope_ * start_, growth = slope_ * rise_;
        A_ = G_.dot(G_) - hh_ * (growth * growth);
        B_ = F.dot(G_) - hh_ * (radius * growth);
        C_ = F.dot(F) - hh_ * (radius * radius);
        unit_ = ConeBounds::of_form * scale_;
    }

    /// Computes a root by the sum of like signs: A t + B is -root at the entry, +root at the exit.
    double crossing(int way) const {
        const bool near = way * B_ > 0;
        const double other = near ? -way * C_ : way * A_,
                     error_bound = unit_ * (near ? far2_ : dd_);
        if (other < -error_bound) return no_hit;  // behind
        if (!(ConeBounds::of_rest * other >= error_bound)) return uncertain;
        return clipped(near ? other / sum_ : sum_ / other);
    }

    /// Returns t, or no_hit beyond the ends, which also cut off the mirror nappe.
    double clipped(double t) const {
        if (!(t > tmin_)) return no_hit;
        const double climb = t * rise_, z = start_ + climb, inside = std::min(z, hh_ - z);
        const double error_bound2 =
            t_tolerance * t_tolerance * (climb * climb) +
            ConeBounds::of_height * ConeBounds::of_height * hh_ * (hh_ + far2_ + t * t * dd_);
        if (!(inside * inside > error_bound2)) return uncertain;
        return inside > 0 ? t : no_hit;
    }

    const Cone& cone_;
    const Vec3 w_, d_, h_;
    const double tmin_, spread_;
    const double hh_, dd_, far2_, scale_, slope_;
    const Vec3 G_;
    double start_, rise_, A_, B_, C_, unit_, sum_;
};

}  // namespace etalon
