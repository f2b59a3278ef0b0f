// First hit of a ray on a cone in plain double, with a bound on all rounding errors. What the bound
// leaves uncertain is decided by core/intersect/shapes/cone_exact.h.
#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/cone_fast.h"
#include "core/intersect/shapes/cone_line.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// The form |F + t G|^2 - (r0 + t r1)^2 = alpha t^2 + 2 beta t + gam, with t seen from the middle.
///
/// Its error, u = 2^-53: three roundings leave w off by 2 u (|w| + |middle d|), one leaves h off by
/// u |h|, and a cross or dot product adds less than 3 u of its factors. So F and start are off by
/// less than e_place; (F, r0) and (G, r1), as vectors of the lengths rho and speed, by less than
/// e_rho and e_speed. All else follows from these; their constants are rounded up by more than any
/// higher order.
class ConeBoundsCheck {
  public:
    ConeBoundsCheck(const Cone& c, const RayQuery& q)
        : cone_(c), query_(q), axis_(c), d_(axis_, q.ray.direction) {
        const Vec3 f = q.ray.origin - c.base;
        middle_ = middle(c, axis_, d_, f);
        const ConePoint w(c, axis_, f + middle_ * q.ray.direction);
        F_ = w.F;
        start_ = w.start;
        r0_ = w.r0;
        alpha_ = d_.G2 - d_.r1 * d_.r1;
        beta_ = F_.dot(d_.G) - r0_ * d_.r1;
        gam_ = F_.dot(F_) - r0_ * r0_;
        discriminant_ = beta_ * beta_ - alpha_ * gam_;
        bound_errors();
    }

    /// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain. Where
    /// alpha is negative the line is steeper than the cone and crosses either nappe once: the
    /// mirror nappe is left out.
    double first_hit(Sides sides) const {
        if (!in_range_) return uncertain;
        if (discriminant_ < -e_discriminant_) return no_hit;
        if (!(discriminant_ > 4 * e_discriminant_)) return stays_clear() ? no_hit : uncertain;
        const bool steep = is_steep();
        if (sides != Sides::back && !(steep && d_.r1 < 0)) {
            const double t = root(in);
            if (t <= infinity) return t;
        }
        return sides == Sides::front || (steep && d_.r1 > 0) ? no_hit : root(out);
    }

  private:
    static constexpr int in = -1, out = 1;

    void bound_errors() {
        constexpr double u = unit_roundoff;
        const double rho2 = F_.dot(F_) + r0_ * r0_, speed2 = d_.G2 + d_.r1 * d_.r1;
        const double slope = std::abs(axis_.slope);
        const double step = std::abs(query_.dz) * axis_.length;  // |d||h| <= sqrt(3) step
        rho_ = std::sqrt(rho2);
        speed_ = std::sqrt(speed2);
        e_place_ = u * (6.5 * (std::abs(start_) + rho_) + 4 * std::abs(middle_) * step);
        e_rho_ = e_place_ + slope * (e_place_ + 16 * u * std::abs(start_)) + 8 * u * rho_;
        e_rise_ = 7 * u * step;
        e_speed_ = (1 + slope) * e_rise_ + 7 * u * speed_;
        // beta^2 and alpha gam are at most (rho speed)^2, and off by at most 3 e (rho speed + e).
        const double e = rho_ * e_speed_ + speed_ * e_rho_ + e_rho_ * e_speed_;
        e_discriminant_ = 6 * e * (rho_ * speed_ + e);
        e_alpha_ = 2.7 * speed_ * e_speed_;  // used where the above shows e_speed < speed / 12
        // Excludes relevant underflow, and overflow.
        constexpr double least = 0x1p-900, most = 0x1p900;
        const double product = rho2 * speed2;
        in_range_ = std::min({axis_.height, rho2, speed2, product}) > least &&
                    std::max({axis_.height, rho2, speed2, product}) < most;
    }

    bool is_steep() const { return alpha_ < -e_alpha_; }

    /// Computes a root by the sum of like signs. alpha t + beta, half the rise of the form, is
    /// -root at the entry and +root at the exit.
    ///
    /// The computed t is a root of a form that differs from the true one, there, by at most e_form:
    /// the vectors F + t G and r(t) are of equal length and together off by at most e, and products
    /// are rounded: the squares of the lengths differ by 6 u reach^2, so neither is above radius +
    /// sqrt(6 u) reach, and 1e-7 is over three times sqrt(6 u). Where the true form has a
    /// discriminant D of more than 3/4 of the computed one, and D + alpha e_form of more than 5/12,
    /// its root is within e_form / (sqrt(D) + sqrt(D + alpha e_form)).
    double root(int way) const {
        constexpr double u = unit_roundoff;
        const double root = std::sqrt(discriminant_), sum = std::abs(beta_) + root;
        const bool near = way * beta_ > 0;
        const double t = (near ? -way * gam_ : way * sum) / (near ? sum : alpha_);
        const double reach = rho_ + speed_ * std::abs(t), e = e_rho_ + e_speed_ * std::abs(t);
        const double radius = std::abs(r0_ + t * d_.r1);
        const double e_form = e * (3 * radius + 2 * e + 1e-7 * reach) + 6 * u * reach * reach;
        if (!(3 * (std::abs(alpha_) + e_alpha_) * e_form <= discriminant_)) {
            return !near && is_out_of_reach(sum) ? no_hit : uncertain;
        }
        const double e_t = 0.75 * e_form / root + 7 * u * std::abs(t);
        return clipped(t, e_t);
    }

    /// Returns t, or no_hit beyond the ends. The apex is no end for a steep line, which otherwise
    /// might pass between the two nappes.
    double clipped(double t, double e_t) const {
        const double tmin = query_.ray.tmin, from_origin = middle_ + t;
        if (from_origin + e_t <= tmin) return no_hit;
        const bool steep = is_steep();
        const double lowest = steep && cone_.base_radius == 0 ? -infinity : 0;
        const double highest = steep && cone_.top_radius == 0 ? infinity : axis_.height;
        const double z = start_ + t * d_.rise;
        const double e_z = std::abs(d_.rise) * e_t + 2 * (e_place_ + e_rise_ * std::abs(t)) +
                           6 * unit_roundoff * axis_.height;
        if (z < lowest - e_z || z > highest + e_z) return no_hit;
        const bool certain = z > lowest + e_z && z < highest - e_z;
        if (!(certain && e_t <= t_tolerance * std::abs(from_origin))) return uncertain;
        return from_origin > tmin ? from_origin : no_hit;
    }

    /// Returns whether the root that a small alpha carries far away, +-sum / alpha, is beyond the
    /// ends.
    bool is_out_of_reach(double sum) const {
        const double nearest = sum / (2 * (std::abs(alpha_) + e_alpha_));
        return nearest * (std::abs(d_.rise) - e_rise_) >
               1.01 * (std::abs(start_) + e_place_ + axis_.height);
    }

    /// Returns whether the line, as one parallel to the axis, is inside or outside from end to end.
    bool stays_clear() const {
        const double rise = std::abs(d_.rise) - e_rise_;
        const double longest = 1.01 * (std::abs(start_) + e_place_ + axis_.height) / rise;
        const double gap = std::abs(std::sqrt(F_.dot(F_)) - std::abs(r0_));
        return rise > 0 && gap > 1.5 * (e_rho_ + (speed_ + e_speed_) * longest);
    }

    const Cone& cone_;
    const RayQuery& query_;
    ConeAxis axis_;
    ConeSpeed d_;
    Vec3 F_;
    double middle_, start_, r0_;
    double alpha_, beta_, gam_, discriminant_;
    double rho_, speed_;
    double e_place_, e_rho_, e_rise_, e_speed_, e_alpha_, e_discriminant_;
    bool in_range_;
};

}  // namespace etalon
