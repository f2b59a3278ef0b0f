#include "core/intersect/shapes/cone_exact.h"

#include "core/numerics/dyadic_vec.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// |x a - y b|^2
Dyadic distance2(const Dyadic& x, const DyadicVec& a, const Dyadic& y, const DyadicVec& b) {
    const auto along = [&](std::size_t k) { return square(x * a[k] - y * b[k]); };
    return along(0) + along(1) + along(2);
}

/// Seen from the centre of an end circle: where the ray starts, and how high above the circle.
struct End {
    End(const Vec3& origin, const Vec3& centre, const DyadicVec& h)
        : w(difference(origin, centre)), z(dot(w, h)) {}

    DyadicVec w;
    Dyadic z;
};

/// The surface is hh (hh |w + td|^2 - ((w + td).h)^2) = (R0 + t R1)^2, the cone's radius there
/// times hh: A t^2 + 2 B t + C = 0, and A t + B is -root at the entry and +root at the exit.
class ExactCone {
  public:
    ExactCone(const Cone& c, const Ray& ray);

    ConeCrossing crossing() const;

  private:
    static constexpr int in = -1, out = 1;

    double crossing(int way) const;
    double root(int way) const;
    bool is_surely_within(double t) const;
    int side(int way, const End& end, double radius) const;

    const Cone& cone_;
    DyadicVec d_, h_;
    End base_, top_;
    Dyadic dh_, hh_, A_, B_, C_, discriminant_, R1_;
};

ExactCone::ExactCone(const Cone& c, const Ray& ray)
    : cone_(c),
      d_(exactly(ray.direction)),
      h_(difference(c.top, c.base)),
      base_(ray.origin, c.base, h_),
      top_(ray.origin, c.top, h_),
      dh_(dot(d_, h_)),
      hh_(dot(h_, h_)) {
    const DyadicVec& w = base_.w;
    const Dyadic spread = Dyadic(c.top_radius) - Dyadic(c.base_radius);
    const Dyadic R0 = hh_ * Dyadic(c.base_radius) + spread * base_.z;
    R1_ = spread * dh_;
    A_ = hh_ * (hh_ * dot(d_, d_) - square(dh_)) - square(R1_);
    B_ = hh_ * (hh_ * dot(w, d_) - base_.z * dh_) - R0 * R1_;
    C_ = hh_ * (hh_ * dot(w, w) - square(base_.z)) - square(R0);
    discriminant_ = square(B_) - A_ * C_;
}

ConeCrossing ExactCone::crossing() const {
    if (discriminant_.sign() < 0 || (A_.sign() == 0 && B_.sign() == 0)) return {};
    return {crossing(in), crossing(out)};
}

/// A root between the ends, which belong to the surface. The mirror nappe is beyond an end, but
/// for the apex: of a line that is steeper than the cone it is the one root, on which the line
/// leaves the cone or enters it as the radius falls or rises.
double ExactCone::crossing(int way) const {
    const bool mirrored = A_.sign() < 0 && way * R1_.sign() > 0;
    if (mirrored) return no_hit;
    const double t = root(way);
    const bool within = is_surely_within(t) || (side(way, base_, cone_.base_radius) >= 0 &&
                                                side(way, top_, cone_.top_radius) <= 0);
    return within ? t : no_hit;
}

/// By the sum of like signs. NaN, 0 times infinity, where A vanishes and with it this root.
double ExactCone::root(int way) const {
    const WideDouble a = A_.magnitude(), b = B_.magnitude(), c = C_.magnitude();
    const auto quotient = [](int sign, const WideDouble& x, const WideDouble& y) {
        return sign * static_cast<double>(x / y);
    };
    const WideDouble sum = b + square_root(discriminant_.magnitude());
    if (way * B_.sign() > 0) return quotient(-way * C_.sign(), c, sum);
    return quotient(way * A_.sign(), sum, a);
}

/// A shortcut: t is good to 6 roundings, and its height then to 8 of the terms.
bool ExactCone::is_surely_within(double t) const {
    const double start = base_.z.rounded(), climb = t * dh_.rounded();
    const double z = start + climb;
    const double bound = 16 * unit_roundoff * (std::abs(start) + std::abs(climb));
    return bound > 0x1p-960 && z > bound && hh_.rounded() - z > bound;
}

/// The sign of z at a root, without the root: the line passes the end's plane at t0 = -z / dh. With
/// the form p0 there, which is negative inside the circle, and half its rise s0, what is left to
/// the root is -way p0 / (|s0| + root) where way s0 is positive, and way (|s0| + root) / A
/// elsewhere.
int ExactCone::side(int way, const End& end, double radius) const {
    if (dh_.sign() == 0) return end.z.sign();
    const Dyadic p0 = distance2(dh_, end.w, end.z, d_) - square(Dyadic(radius) * dh_);
    const int rise = way * (B_ * dh_ - A_ * end.z).sign() * dh_.sign();
    if (rise > 0) return -way * p0.sign() * dh_.sign();
    const bool tangent = rise == 0 && discriminant_.sign() == 0;
    return tangent ? 0 : way * A_.sign() * dh_.sign();
}

}  // namespace

ConeCrossing exact_crossing(const Cone& cone, const Ray& ray) {
    if (is_degenerate(cone) || !is_finite(ray.origin) || !is_finite(ray.direction)) return {};
    return ExactCone(cone, ray).crossing();
}

}  // namespace etalon
