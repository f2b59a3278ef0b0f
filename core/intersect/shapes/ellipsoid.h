#pragma once

#include "core/intersect/shapes/affine_exact.h"
#include "core/intersect/shapes/affine_surface.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/unit_line.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns half of the extent: for each axis, the length of the map's row.
inline Vec3 reach(const Ellipsoid& e) {
    return reach(e.to_world.x, e.to_world.y, e.to_world.z);
}

inline Box3 bounds(const Geometry&, const Ellipsoid& e) {
    if (!e.frame.exists()) return {};
    return box_around(e.to_world.origin, e.to_world.origin, reach(e));
}

/// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain.
inline double fast_path(const Ellipsoid& e, Sides sides, const RayQuery& q) {
    const LocalLine line(e.to_world.origin, e.frame, q.ray);
    const double rows = e.frame.length(0) + e.frame.length(1) + e.frame.length(2);
    if (!line.is_in_range(rows)) return uncertain;
    const UnitLine unit(line.w, line.error_of_w(rows), line.d, line.error_of_d(rows));
    if (unit.leaves() || unit.misses()) return no_hit;
    return unit.is_certain() ? first_ahead(unit.interval(), sides, q.ray.tmin) : uncertain;
}

/// Returns the first visible t. Hit or miss is right for every ray, and t good to t_tolerance. The
/// direction is not normalized in local coordinates, so t is that of world space.
inline double first_hit(const Geometry&, const Ellipsoid& e, Sides sides, const RayQuery& q) {
    const double t = fast_path(e, sides, q);
    if (t != uncertain) return t;
    const Passage x = exact_passage(e, q.ray);
    return first_visible(x.entry, x.exit, sides, q.ray.tmin);
}

inline SurfacePoint surface(const Geometry&, const Ellipsoid& e, const RayQuery& q, double t) {
    const Vec3 seen = q.ray.origin - e.to_world.origin + t * q.ray.direction;
    const Vec3 near = e.frame.vector(seen), gradient = e.frame.normal(unit_vector(near));
    const Vec3 on = moved_onto_surface(seen, gradient, near.length() - 1);
    const Vec3 local = unit_vector(e.frame.vector(on));
    const Vec3 normal = unit_vector(e.frame.normal(local));
    const Vec3 magnitude = abs(e.to_world.origin) + reach(e);
    return {e.frame.point(local), position_error(magnitude, 0), normal, normal};
}

/// Returns the image of the unit sphere's parametrization, which is pbrt's. dpdu x dpdv points
/// outward, or inward where the map mirrors.
inline Parametrization parametrization(const Geometry&, const Ellipsoid& e, const SurfacePoint& p) {
    const Vec3 local = unit_vector(pulled_back(e.to_world, p.normal));
    return image(e.to_world, sphere_chart(local));
}

}  // namespace etalon
