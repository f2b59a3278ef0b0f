#include "core/intersect/shapes/quadric_exact.h"

#include "core/intersect/shapes/roots.h"
#include "core/numerics/dyadic_vec.h"
#include "core/numerics/rounding.h"
#include "core/scene/quadric_form.h"

namespace etalon {
namespace {

using ExactForm = QuadricForm<Dyadic>;

std::array<Dyadic, 10> exact_numbers(const std::array<double, 10>& numbers) {
    std::array<Dyadic, 10> exact;
    std::transform(numbers.begin(), numbers.end(), exact.begin(),
                   [](double x) { return Dyadic(x); });
    return exact;
}

int sign(double x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// A t^2 + 2 B t + C on the ray. A t + B is -root where the form falls, where the front is seen,
/// and +root where it rises.
class ExactQuadric {
  public:
    ExactQuadric(const Quadric& s, const Ray& ray) : clip_(s.clip), ray_(ray) {
        const auto line = ExactForm(exact_numbers(s.coefficients))
                              .on_line(difference(ray.origin, s.centre), exactly(ray.direction));
        A_ = line.A;
        B_ = line.B;
        C_ = line.C;
        discriminant_ = square(B_) - A_ * C_;
    }

    double first_hit(Sides sides) const;

  private:
    static constexpr int falling = -1, rising = 1;

    double root(int way) const;
    bool is_within(int way, double t) const;
    int side(int way, int axis, double face) const;

    const Box3& clip_;
    const Ray& ray_;
    Dyadic A_, B_, C_, discriminant_;
};

/// Returns the first visible t. Both roots of a tangent are its one point, which shows both sides.
double ExactQuadric::first_hit(Sides sides) const {
    if (discriminant_.sign() < 0 || (A_.sign() == 0 && B_.sign() == 0)) return no_hit;
    const int first = A_.sign() < 0 ? rising : falling;
    for (const int way : {first, -first}) {
        const bool hidden = sides == (way == falling ? Sides::back : Sides::front);
        const double t = root(way);
        if (!hidden && is_ahead(t, ray_.tmin) && is_within(way, t)) return t;
    }
    return no_hit;
}

/// Computes a root by the sum of like signs; NaN (0 times infinity) if A = 0 leaves no such root.
double ExactQuadric::root(int way) const {
    const WideDouble a = A_.magnitude(), b = B_.magnitude(), c = C_.magnitude();
    const WideDouble sum = b + square_root(discriminant_.magnitude());
    if (way * B_.sign() > 0) return -way * C_.sign() * static_cast<double>(c / sum);
    return way * A_.sign() * static_cast<double>(sum / a);
}

bool ExactQuadric::is_within(int way, double t) const {
    for (int k = 0; k < 3; ++k) {
        const double o = ray_.origin[k], step = t * ray_.direction[k], p = o + step;
        // t is good to 6 roundings.
        const double error_bound = 16 * unit_roundoff * (std::abs(o) + std::abs(step)) + 0x1p-1000;
        if (p - clip_.min[k] > error_bound && clip_.max[k] - p > error_bound) continue;
        if (side(way, k, clip_.min[k]) < 0 || side(way, k, clip_.max[k]) > 0) return false;
    }
    return true;
}

/// Returns the sign of p - face at a root, without computing the root. The line passes the face at
/// t0 = (face - o) / d. With the form p0 there and half its rise s0 = A t0 + B, the distance to the
/// root is -p0 / (s0 + way root) where way s0 is positive, and (way root - s0) / A elsewhere.
int ExactQuadric::side(int way, int axis, double face) const {
    const int forward = sign(ray_.direction[axis]);
    if (forward == 0) return sign(ray_.origin[axis] - face);
    const Dyadic distance = Dyadic(face) - Dyadic(ray_.origin[axis]), d(ray_.direction[axis]);
    const Dyadic s0 = A_ * distance + B_ * d;
    const int rise = way * s0.sign() * forward;
    if (rise > 0) {
        const Dyadic p0 = (s0 + B_ * d) * distance + C_ * square(d);
        return -forward * way * p0.sign();
    }
    const bool tangent = rise == 0 && discriminant_.sign() == 0;
    return tangent ? 0 : forward * way * A_.sign();
}

}  // namespace

double exact_first_hit(const Quadric& s, Sides sides, const Ray& ray) {
    if (is_degenerate(s) || !is_finite(ray.origin) || !is_finite(ray.direction)) return no_hit;
    return ExactQuadric(s, ray).first_hit(sides);
}

}  // namespace etalon
