// The fast path of a cone for several rays: see cone_fast.h, which derives the errors. Compiled for
// each instruction set.
#if defined(ETALON_CONE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CONE_LANES_INL_H
#undef ETALON_CONE_LANES_INL_H
#else
#define ETALON_CONE_LANES_INL_H
#endif

#include "core/intersect/shapes/cone_fast.h"
#include "core/intersect/shapes/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

class ConeLanes {
  public:
    HWY_INLINE ConeLanes(const Cone& c, const RayLanes& rays)
        : cone_(c),
          tmin_(rays.tmin),
          w_(rays.origin - broadcast(c.base)),
          d_(rays.direction),
          h_(broadcast(c.top - c.base)),
          spread_(c.top_radius - c.base_radius),
          hh_((c.top - c.base).dot(c.top - c.base)),
          scale_(hh_ + spread_ * spread_),
          slope_(spread_ / hh_),
          dd_(d_.dot(d_)),
          far2_(w_.dot(w_) + broadcast(c.base_radius * c.base_radius)),
          G_(d_.cross(h_)) {}

    HWY_INLINE HitLanes first_hits(Sides sides) {
        const Doubles m = w_.dot(G_), size2 = dd_ * broadcast(scale_) * far2_;
        Vec3Lanes V = broadcast(cone_.base_radius) * G_;
        if (spread_ != 0) V = V + (broadcast(spread_) * d_.cross(w_) + broadcast(slope_) * m * h_);
        const Doubles V2 = V.dot(V), m2 = m * m, difference = V2 - m2;
        const Doubles error_bound2 =
            broadcast(ConeBounds::of_difference * ConeBounds::of_difference) * size2 *
            hn::Max(V2, m2);
        const DoubleMask certain =
            hn::And(hn::And(difference * difference > error_bound2,
                            error_bound2 > broadcast(ConeBounds::least_error2)),
                    is_in_range(size2));
        const DoubleMask missed = hn::And(certain, difference < broadcast(0));
        if (hn::AllTrue(DoubleTag(), missed)) return misses();
        const Doubles hh = broadcast(hh_);
        HitLanes hits = first_crossings(sides, hh * difference, hh * (error_bound2 / difference));
        hits.t = hn::IfThenElse(missed, broadcast(no_hit), hits.t);
        hits.uncertain = hn::AndNot(missed, hn::Or(hits.uncertain, hn::Not(certain)));
        return hits;
    }

  private:
    HWY_INLINE DoubleMask is_in_range(Doubles size2) const {
        const Doubles least = hn::Min(hn::Min(broadcast(hh_), dd_), far2_);
        const Doubles most = broadcast(scale_) * size2;
        const DoubleMask in_range = hn::And(least > broadcast(ConeBounds::least_size2),
                                            hn::And(most > broadcast(ConeBounds::least_product),
                                                    most < broadcast(ConeBounds::largest_product)));
        const bool has_radii = std::min(cone_.base_radius, cone_.top_radius) >= 0;
        return has_radii ? in_range : hn::FirstN(DoubleTag(), 0);
    }

    HWY_INLINE HitLanes first_crossings(Sides sides, Doubles discriminant,
                                        Doubles root_error_bound2) {
        expand();
        const Doubles unit = broadcast(unit_), error_bound2 = unit * unit * (dd_ * far2_);
        const DoubleMask leaves = hn::And(hn::And(B_ > broadcast(0), A_ > unit * dd_),
                                          hn::And(C_ > unit * far2_, B_ * B_ > error_bound2));
        sum_ = hn::Abs(B_) + hn::Sqrt(discriminant);
        const DoubleMask good = root_error_bound2 + error_bound2 <=
                                broadcast(ConeBounds::of_sum * ConeBounds::of_sum) * (sum_ * sum_);
        HitLanes hits = sides == Sides::back ? misses() : crossings(-1);
        if (sides != Sides::front) {
            const HitLanes exits = crossings(1);
            const DoubleMask passed = hn::AndNot(hits.uncertain, hn::IsNaN(hits.t));
            hits.t = hn::IfThenElse(passed, exits.t, hits.t);
            hits.uncertain = hn::Or(hits.uncertain, hn::And(passed, exits.uncertain));
        }
        hits.t = hn::IfThenElse(leaves, broadcast(no_hit), hits.t);
        hits.uncertain = hn::AndNot(leaves, hn::Or(hits.uncertain, hn::Not(good)));
        return hits;
    }

    HWY_INLINE void expand() {
        const Vec3Lanes F = w_.cross(h_);
        start_ = w_.dot(h_);
        rise_ = d_.dot(h_);
        const Doubles hh = broadcast(hh_), slope = broadcast(slope_);
        const Doubles radius = broadcast(cone_.base_radius) + slope * start_;
        const Doubles growth = slope * rise_;
        A_ = G_.dot(G_) - hh * (growth * growth);
        B_ = F.dot(G_) - hh * (radius * growth);
        C_ = F.dot(F) - hh * (radius * radius);
        unit_ = ConeBounds::of_form * scale_;
    }

    /// Computes the entries (`way` -1) or exits (1).
    HWY_INLINE HitLanes crossings(int way) const {
        const Doubles sign = broadcast(way);
        const DoubleMask near = sign * B_ > broadcast(0);
        const Doubles other = hn::IfThenElse(near, hn::Neg(sign) * C_, sign * A_);
        const Doubles error_bound = broadcast(unit_) * hn::IfThenElse(near, far2_, dd_);
        const DoubleMask behind = other < hn::Neg(error_bound);
        const DoubleMask good = broadcast(ConeBounds::of_rest) * other >= error_bound;
        HitLanes hits =
            clipped(hn::IfThenElse(near, other, sum_) / hn::IfThenElse(near, sum_, other));
        hits.t = hn::IfThenElse(behind, broadcast(no_hit), hits.t);
        hits.uncertain = hn::AndNot(behind, hn::Or(hits.uncertain, hn::Not(good)));
        return hits;
    }

    HWY_INLINE HitLanes clipped(Doubles t) const {
        const Doubles hh = broadcast(hh_), climb = t * rise_, z = start_ + climb;
        const Doubles inside = hn::Min(z, hh - z);
        const Doubles error_bound2 =
            broadcast(t_tolerance * t_tolerance) * (climb * climb) +
            broadcast(ConeBounds::of_height * ConeBounds::of_height * hh_) *
                (hh + far2_ + t * t * dd_);
        const DoubleMask is_beyond = t > tmin_;
        const DoubleMask is_hit = hn::And(is_beyond, inside > broadcast(0));
        return {hn::IfThenElse(is_hit, t, broadcast(no_hit)),
                hn::And(is_beyond, hn::Not(inside * inside > error_bound2))};
    }

    const Cone& cone_;
    const Doubles tmin_;
    const Vec3Lanes w_, d_, h_;
    const double spread_, hh_, scale_, slope_;
    const Doubles dd_, far2_;
    const Vec3Lanes G_;
    Doubles start_, rise_, A_, B_, C_, sum_;
    double unit_;
};

HWY_INLINE HitLanes first_hits(const Cone& c, Sides sides, const RayLanes& rays) {
    return ConeLanes(c, rays).first_hits(sides);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
