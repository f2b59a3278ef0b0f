#include "core/intersect/shapes/sphere.h"

#include "core/intersect/shapes/exact_quadratic.h"
#include "core/numerics/dyadic_vec.h"
#include "core/numerics/exact.h"

namespace etalon {
namespace {

using Difference = Expansion<2>;

Expansion<4> product(double x, const Difference& y) {
    return Expansion<1>(x) * y;
}

}  // namespace

double fine_gap(const Sphere& s, const Vec3& origin) {
    const TwoTerm square = two_product(s.radius, s.radius);
    double sum = -square.value, rest = -square.error;
    for (int k = 0; k < 3; ++k) {
        const TwoTerm f = two_difference(origin[k], s.centre[k]);
        const TwoTerm f2 = two_product(f.value, f.value), next = two_sum(sum, f2.value);
        sum = next.value;
        rest += next.error + f2.error + 2 * f.value * f.error;
    }
    return sum + rest;
}

namespace {

/// Returns whether a bit of a product of four such numbers, scaled, is below the range of double.
/// False for a NaN.
bool is_below_range(const Vec3& v, double scale) {
    const auto is = [&](double x) { return x != 0 && std::abs(x * scale) <= 0x1p-200; };
    return is(v.x) || is(v.y) || is(v.z);
}

/// The same in integers, for a ray from 2^200 radii away or with components as unequal as that.
[[gnu::noinline]] double widest_first_hit(const Sphere& s, Sides sides, const Ray& ray) {
    const bool all_finite = is_finite(ray.origin) && is_finite(ray.direction) &&
                            is_finite(s.centre) && std::isfinite(s.radius);
    if (!all_finite) return no_hit;
    const DyadicVec f = difference(ray.origin, s.centre), d = exactly(ray.direction);
    const ExactQuadratic form(dot(d, d), dot(f, d), dot(f, f) - square(Dyadic(s.radius)));
    if (!form.has_roots()) return no_hit;
    return first_visible(form.root(ExactQuadratic::in), form.root(ExactQuadratic::out), sides,
                         ray.tmin);
}

}  // namespace

/// Scales by powers of two, so that no product leaves the range of double: the sphere by `near`,
/// the direction by `slow`.
double exact_first_hit(const Sphere& s, Sides sides, const RayQuery& q) {
    if (!(s.radius > 0 && s.radius < infinity)) return no_hit;
    const double size = std::max(max_abs(q.ray.origin - s.centre), s.radius);
    const double near = power_of_two_reciprocal(size);
    const double slow = power_of_two_reciprocal(max_abs(q.ray.direction));
    if (is_below_range(q.ray.direction, slow) || is_below_range(q.ray.origin, near) ||
        is_below_range(s.centre, near) || is_below_range(Vec3(s.radius), near)) {
        return widest_first_hit(s, sides, q.ray);
    }
    const Vec3 d = q.ray.direction * slow, o = q.ray.origin * near, centre = s.centre * near;
    const Expansion<1> r(s.radius * near);
    const std::array<Difference, 3> f = {Difference(two_difference(o.x, centre.x)),
                                         Difference(two_difference(o.y, centre.y)),
                                         Difference(two_difference(o.z, centre.z))};
    const auto a = Difference(two_product(d.x, d.x)) + Difference(two_product(d.y, d.y)) +
                   Difference(two_product(d.z, d.z));
    const auto minus_b = product(d.x, f[0]) + product(d.y, f[1]) + product(d.z, f[2]);
    const auto c = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - r * r;
    const double discriminant = (minus_b * minus_b - a * c).estimate();
    if (!(discriminant >= 0)) return no_hit;
    const double b = -minus_b.estimate(), sum = std::abs(b) + std::sqrt(discriminant);
    const int unit = std::ilogb(slow) - std::ilogb(near);  // unit of t, which may not be a double
    const double tmin = std::ldexp(q.ray.tmin, -unit);
    const double t = std::ldexp(first_root(a.estimate(), b, c.estimate(), sum, sides, tmin), unit);
    return is_ahead(t, q.ray.tmin) ? t : no_hit;
}

}  // namespace etalon
