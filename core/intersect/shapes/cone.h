#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/circle.h"
#include "core/intersect/shapes/cone_bounds_check.h"
#include "core/intersect/shapes/cone_exact.h"
#include "core/intersect/shapes/cone_fast.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/numerics/transforms.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns the box of the two end circles.
inline Box3 bounds(const Geometry&, const Cone& c) {
    Box3 box;
    if (is_degenerate(c)) return box;
    const Vec3 reach = reach_of_circle(c.top - c.base);
    box.extendBy(c.base - c.base_radius * reach);
    box.extendBy(c.base + c.base_radius * reach);
    box.extendBy(c.top - c.top_radius * reach);
    box.extendBy(c.top + c.top_radius * reach);
    return box;
}

/// Decides what the fast path leaves uncertain: in double with an error bound, and in exact
/// arithmetic where that is uncertain, too.
[[gnu::noinline]] inline double careful_first_hit(const Cone& c, Sides sides, const RayQuery& q) {
    const double t = ConeBoundsCheck(c, q).first_hit(sides);
    if (t != uncertain) return t < infinity && !is_degenerate(c) ? t : no_hit;
    const Passage x = exact_passage(c, q.ray);
    return first_visible(x.entry, x.exit, sides, q.ray.tmin);
}

/// Returns the first visible t. Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Geometry&, const Cone& c, Sides sides, const RayQuery& q) {
    const double t = ConeFastPath(c, q).first_hit(sides);
    return t == uncertain ? careful_first_hit(c, sides, q) : t;
}

/// Moves the position onto the circle at its height. At the apex the normal is the axis.
inline SurfacePoint surface(const Geometry&, const Cone& c, const RayQuery& q, double t) {
    const Vec3 h = c.top - c.base;
    const double length = std::sqrt(h.dot(h));
    const Vec3 w = q.ray.origin - c.base + t * q.ray.direction;
    const double along = w.dot(h) / h.dot(h), s = std::clamp(along, 0.0, 1.0);
    const double spread = c.top_radius - c.base_radius;
    const Vec3 radial = w - along * h;
    const double distance = std::sqrt(radial.dot(radial));
    const Vec3 outward = distance > 0 ? radial / distance : Vec3(0);
    const Vec3 normal = normalized(length * outward - (spread / length) * h);
    const Vec3 position = c.base + s * h + (c.base_radius + s * spread) * outward;
    const double extent = length + std::max(c.base_radius, c.top_radius);
    return {position, position_error(abs(c.base), extent), normal, normal};
}

/// Returns pbrt's parametrization (of a cylinder, a cone or a hyperboloid), with v from the base to
/// the top and u from the x axis of about_axis(). dpdu x dpdv points outward.
inline Parametrization parametrization(const Geometry&, const Cone& c, const SurfacePoint& p) {
    const Vec3 h = c.top - c.base;
    const Affine map = about_axis(c.base, h);
    const double v = saturated((p.position - c.base).dot(h) / h.dot(h));
    const Vec3 side = outward(pulled_back(map, p.normal));
    return image(map, cone_chart(side, v, c.base_radius, c.top_radius, std::sqrt(h.dot(h))));
}

}  // namespace etalon
