#include "core/intersect/shapes/cone_exact.h"

#include "core/intersect/shapes/exact_quadratic.h"
#include "core/numerics/dyadic_vec.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// Start of the ray, seen from the centre of an end circle, and its height above the circle.
struct End {
    End(const Vec3& origin, const Vec3& centre, const DyadicVec& h)
        : w(difference(origin, centre)), z(dot(w, h)) {}

    DyadicVec w;
    Dyadic z;
};

/// The surface is hh (hh |w + td|^2 - ((w + td).h)^2) = (R0 + t R1)^2, the cone's radius there
/// times hh: A t^2 + 2 B t + C = 0.
class ExactCone {
  public:
    ExactCone(const Cone& c, const Ray& ray);

    Passage passage() const;

  private:
    static constexpr int in = ExactQuadratic::in, out = ExactQuadratic::out;

    ExactQuadratic form() const;
    double crossing(int way) const;
    bool is_surely_within(double t) const;

    const Cone& cone_;
    Dyadic spread_;
    DyadicVec d_, h_;
    End base_, top_;
    Dyadic dh_, hh_, R1_;
    ExactQuadratic form_;
};

ExactCone::ExactCone(const Cone& c, const Ray& ray)
    : cone_(c),
      spread_(Dyadic(c.top_radius) - Dyadic(c.base_radius)),
      d_(exactly(ray.direction)),
      h_(difference(c.top, c.base)),
      base_(ray.origin, c.base, h_),
      top_(ray.origin, c.top, h_),
      dh_(dot(d_, h_)),
      hh_(dot(h_, h_)),
      R1_(spread_ * dh_),
      form_(form()) {}

ExactQuadratic ExactCone::form() const {
    const DyadicVec& w = base_.w;
    const Dyadic R0 = hh_ * Dyadic(cone_.base_radius) + spread_ * base_.z;
    return {hh_ * (hh_ * dot(d_, d_) - square(dh_)) - square(R1_),
            hh_ * (hh_ * dot(w, d_) - base_.z * dh_) - R0 * R1_,
            hh_ * (hh_ * dot(w, w) - square(base_.z)) - square(R0)};
}

Passage ExactCone::passage() const {
    if (!form_.has_roots()) return {};
    return {crossing(in), crossing(out)};
}

/// Returns a root between the ends, which belong to the surface. The mirror nappe is beyond an end,
/// except for the apex. For a line that is steeper than the cone the apex is a single root, at
/// which the line leaves the cone or enters it as the radius falls or rises.
double ExactCone::crossing(int way) const {
    const bool mirrored = form_.opening() < 0 && way * R1_.sign() > 0;
    if (mirrored) return no_hit;
    const double t = form_.root(way);
    const bool within = is_surely_within(t) || (form_.sign_at_root(way, base_.z, dh_) >= 0 &&
                                                form_.sign_at_root(way, top_.z, dh_) <= 0);
    return within ? t : no_hit;
}

/// Early out: t is good to 6 roundings, and its height then to 8 of the terms.
bool ExactCone::is_surely_within(double t) const {
    const double start = base_.z.rounded(), climb = t * dh_.rounded();
    const double z = start + climb;
    const double bound = 16 * unit_roundoff * (std::abs(start) + std::abs(climb));
    return bound > 0x1p-960 && z > bound && hh_.rounded() - z > bound;
}

}  // namespace

Passage exact_passage(const Cone& cone, const Ray& ray) {
    if (is_degenerate(cone) || !is_finite(ray.origin) || !is_finite(ray.direction)) return {};
    return ExactCone(cone, ray).passage();
}

}  // namespace etalon
