#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

inline Box3 bounds(const Scene&, const Sphere& s) {
    if (!is_finite(s.centre) || !(s.radius > 0) || !std::isfinite(s.radius)) return {};
    return {s.centre - Vec3(s.radius), s.centre + Vec3(s.radius)};
}

/// The discriminant is taken at the ray's closest approach to the centre, where it does not cancel
/// with distance, and the roots by the sum of like signs (Haines, Günther & Akenine-Möller 2019,
/// Ray Tracing Gems ch. 7).
inline double first_hit(const Scene&, const Sphere& s, Sides sides, const RayQuery& q) {
    const Vec3 f = q.ray.origin - s.centre;
    const Vec3& d = q.ray.direction;
    const double a = d.dot(d);
    const double b = -f.dot(d);
    const Vec3 approach = f + (b / a) * d;
    const double discriminant = s.radius * s.radius - approach.dot(approach);
    if (!(discriminant >= 0 && s.radius > 0)) return no_hit;
    const double c = f.dot(f) - s.radius * s.radius;
    const double root = std::sqrt(a * discriminant);
    if (b >= 0) return first_visible(c / (b + root), (b + root) / a, sides, q.ray.tmin);
    return first_visible((b - root) / a, c / (b - root), sides, q.ray.tmin);
}

inline SurfacePoint surface(const Scene&, const Sphere& s, const RayQuery& q, double t) {
    const Vec3 f = q.ray.origin - s.centre + t * q.ray.direction;
    const Vec3 normal = f / std::sqrt(f.dot(f));
    const Vec3 position = s.centre + s.radius * normal;
    return {position, position_error(abs(s.centre), s.radius), normal, normal};
}

}  // namespace etalon
