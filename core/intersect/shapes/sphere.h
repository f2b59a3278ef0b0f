#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/numerics/rounding.h"
#include "core/scene/geometry.h"

namespace etalon {

inline Box3 bounds(const Geometry&, const Sphere& s) {
    if (!is_finite(s.centre) || !(s.radius > 0) || !std::isfinite(s.radius)) return {};
    return {s.centre - Vec3(s.radius), s.centre + Vec3(s.radius)};
}

/// Returns the first visible root of a t^2 - 2 b t + c = 0, for sum = |b| + sqrt(b^2 - a c), as a
/// quotient in which nothing cancels (Press et al. 2007, Numerical Recipes, section 5.6).
inline double first_root(double a, double b, double c, double sum, Sides sides, double tmin) {
    if (b >= 0) return first_visible(c / sum, sum / a, sides, tmin);
    return first_visible(-sum / a, -c / sum, sides, tmin);
}

/// Returns |o - centre|^2 - r^2 for origins next to the surface, where it cancels. The error is at
/// most fine_error_bound times the sum of the two squares (and u relatively). What is left of the
/// squares is summed with its errors; those are at most 7 u of that sum together, of which their
/// own roundings, a dozen, lose u each.
double fine_gap(const Sphere& s, const Vec3& origin);
inline constexpr double fine_error_bound = 128 * unit_roundoff * unit_roundoff;

/// Returns the same as first_hit, from exact arithmetic: hit and miss are right for every ray, and
/// t to a few ulp. Slow.
double exact_first_hit(const Sphere& s, Sides sides, const RayQuery& q);

/// Intersects the sphere with the line f + t d, seen from the centre. The discriminant b^2 - a c is
/// computed as a r^2 - |f x d|^2 (Lagrange's identity), which does not cancel with distance: the
/// cross product is how far the line passes from the centre.
///
/// Hit and miss are right for every ray, and t to t_tolerance: where the roundings of the fast path
/// (Higham 2002, ch. 3) could change either, as they do at silhouettes, the exact one takes over.
inline double first_hit(const Geometry&, const Sphere& s, Sides sides, const RayQuery& q) {
    constexpr double u = unit_roundoff, worst = t_tolerance / 2;
    const Vec3 f = q.ray.origin - s.centre;
    const Vec3& d = q.ray.direction;
    const double a = d.dot(d), b = -f.dot(d), f2 = f.dot(f), r2 = s.radius * s.radius;
    double c = f2 - r2, error_bound_of_c = 8 * u * (f2 + r2);
    if (worst * std::abs(c) < error_bound_of_c) {  // as for rays that leave the surface
        c = fine_gap(s, q.ray.origin);
        error_bound_of_c = fine_error_bound * (f2 + r2);
    }
    if (c > error_bound_of_c && b <= 0) return no_hit;  // outside, and on its way out

    const Vec3 m = f.cross(d);
    const double m2 = m.dot(m), ar2 = a * r2, largest = std::max(m2, ar2);
    const double discriminant = ar2 - m2;
    const double error_bound2 = (16 * u) * (16 * u) * largest * (a * f2 + largest);
    const bool in_range = s.radius > 0 && std::min(a, r2) > 0x1p-900;
    if (!in_range || !(discriminant * discriminant > error_bound2))
        return exact_first_hit(s, sides, q);
    if (discriminant < 0) return no_hit;

    const double sum = std::abs(b) + std::sqrt(discriminant), sum2 = sum * sum;
    const bool from_c = (b > 0) == (c > 0);  // c / sum is a root ahead
    const bool good = error_bound2 <= worst * worst * discriminant * sum2 &&
                      (8 * u) * (8 * u) * a * f2 <= worst * worst * sum2 &&
                      (from_c ? worst : 1) * std::abs(c) >= error_bound_of_c;
    if (!good) return exact_first_hit(s, sides, q);
    return first_root(a, b, c, sum, sides, q.ray.tmin);
}

inline SurfacePoint surface(const Geometry&, const Sphere& s, const RayQuery& q, double t) {
    const Vec3 f = q.ray.origin - s.centre + t * q.ray.direction;
    const Vec3 normal = normalized(f);
    const Vec3 position = s.centre + s.radius * normal;
    return {position, position_error(abs(s.centre), s.radius), normal, normal};
}

/// Returns pbrt's parametrization, about the z axis of the world. dpdu x dpdv points outward.
inline Parametrization parametrization(const Geometry&, const Sphere& s, const SurfacePoint& p) {
    const Parametrization unit = sphere_chart(p.normal);
    return {unit.uv, s.radius * unit.dpdu, s.radius * unit.dpdv};
}

}  // namespace etalon
