#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

inline Box3 bounds(const Scene&, const Plane& p) {
    if (!is_finite(p.point) || !is_finite(p.normal) || p.normal == Vec3(0)) return {};
    return {Vec3(-infinity), Vec3(infinity)};
}

/// A ray in the plane, or parallel to it, misses.
inline double first_hit(const Scene&, const Plane& p, Sides sides, const RayQuery& q) {
    const double cosine = p.normal.dot(q.ray.direction);
    const double t = p.normal.dot(p.point - q.ray.origin) / cosine;
    return is_ahead(t, q.ray.tmin) && faces(cosine, sides) ? t : no_hit;
}

inline SurfacePoint surface(const Scene&, const Plane& p, const RayQuery& q, double t) {
    const Vec3 normal = p.normal / std::sqrt(p.normal.dot(p.normal));
    Vec3 position = q.ray.origin + t * q.ray.direction;
    position -= normal.dot(position - p.point) * normal;
    return {position, position_error(abs(position) + abs(p.point), 0), normal, normal};
}

}  // namespace etalon
