#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/numerics/exact.h"
#include "core/scene/geometry.h"

namespace etalon {

inline Box3 bounds(const Geometry&, const Plane& p) {
    if (!is_finite(p.point) || !is_finite(p.normal) || p.normal == Vec3(0)) return {};
    return {Vec3(-infinity), Vec3(infinity)};
}

/// A ray in the plane, or parallel to it, misses. Either product is computed exactly where its
/// roundings could change its sign, or t by more than 2^-47 relatively. A plane that is certainly
/// behind the ray is an early out.
inline double first_hit(const Geometry&, const Plane& p, Sides sides, const RayQuery& q) {
    constexpr double u = unit_roundoff, good = 0.25;  // its roundings are then 2^-49 at most
    const Vec3 &n = p.normal, &d = q.ray.direction, offset = p.point - q.ray.origin;
    double cosine = n.dot(d), distance = n.dot(offset);
    const double cosine_scale = abs(n).dot(abs(d)), distance_scale = abs(n).dot(abs(offset));
    const bool certain = std::abs(cosine) > 4 * u * cosine_scale &&
                         std::abs(distance) > 5 * u * distance_scale &&
                         std::min(cosine_scale, distance_scale) > 0x1p-900;  // no underflow
    if (certain && (cosine > 0) != (distance > 0)) return no_hit;
    if (!certain || std::abs(cosine) < good * cosine_scale) cosine = exact_dot(n, d);
    if (!certain || std::abs(distance) < good * distance_scale) {
        distance = exact_dot(n, p.point, q.ray.origin);
    }
    const double t = distance / cosine;
    return is_ahead(t, q.ray.tmin) && faces(cosine, sides) ? t : no_hit;
}

/// Part of the error bound along the normal that may be left of a point's distance from a plane
/// after the correction. More than that is left where a coordinate was far larger before it: the
/// correction's own roundings are in proportion to that.
inline constexpr double most_left_of_distance = 0.25;

inline SurfacePoint surface(const Geometry&, const Plane& p, const RayQuery& q, double t) {
    const Vec3 normal = normalized(p.normal);
    Vec3 position = q.ray.origin + t * q.ray.direction;
    position -= normal.dot(position - p.point) * normal;
    Vec3 error = position_error(abs(position) + abs(p.point), 0);
    const double left = std::abs(normal.dot(position - p.point));
    if (left > most_left_of_distance * abs(normal).dot(error)) error += Vec3(2 * left);
    return {position, error, normal, normal};
}

/// Returns lengths in the plane, from its point: see plane_chart(). dpdu x dpdv is the unit normal.
inline Parametrization parametrization(const Geometry&, const Plane& plane, const SurfacePoint& p) {
    return plane_chart(p.normal, p.position - plane.point);
}

}  // namespace etalon
