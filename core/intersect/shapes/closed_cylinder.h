#pragma once

#include "core/intersect/shapes/affine_exact.h"
#include "core/intersect/shapes/affine_surface.h"
#include "core/intersect/shapes/closed_cylinder_sieve.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

/// The box of the two caps' circles.
inline Box3 bounds(const Scene&, const ClosedCylinder& c) {
    if (!c.to_local.exists) return {};
    const Affine& m = c.to_world;
    Box3 centres;
    centres.extendBy(m.origin);
    centres.extendBy(m.origin + m.z);
    return box_around(centres.min, centres.max, reach(m.x, m.y));
}

/// Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Scene&, const ClosedCylinder& c, Sides sides, const RayQuery& q) {
    const double t = ClosedCylinderSieve(c, q).first_hit(sides);
    if (t != in_doubt) return t;
    const Passage x = exact_passage(c, q.ray);
    return first_visible(x.entry, x.exit, sides, q.ray.tmin);
}

/// A point of the surface in local coordinates, and its normal in the world.
struct CylinderPoint {
    Vec3 local, normal;
};

/// By how much a coordinate of this gradient may be off where a ray starts that leaves a point.
inline double inset(const Vec3& gradient, const Vec3& normal, const Vec3& error) {
    const double offset = std::abs(gradient.dot(normal)) * abs(normal).dot(error);
    return 2 * (offset + abs(gradient).dot(error));
}

/// The point of the side or of a cap, whichever is nearer in the world. At a rim it is moved along
/// its face, so that a ray that goes inward from there starts inside.
inline CylinderPoint nearest_on(const ClosedCylinder& c, const Vec3& local, const Vec3& error) {
    const double radius = std::hypot(local.x, local.y);
    const Vec3 outward = radius > 0 ? Vec3(local.x, local.y, 0) / radius : Vec3(1, 0, 0);
    const Vec3 up = c.to_local.z, sideways = c.to_local.normal(outward);
    const double cap = local.z < 0.5 ? 0 : 1;
    const double from_cap = std::abs(local.z - cap), from_side = std::abs(radius - 1);
    if (from_cap * max_abs(sideways) < from_side * max_abs(up)) {
        const Vec3 normal = unit_vector((cap == 0 ? -1.0 : 1.0) * up);
        const double widest = std::max(1 - inset(sideways, normal, error), 0.0);
        return {std::min(radius, widest) * outward + Vec3(0, 0, cap), normal};
    }
    const Vec3 normal = unit_vector(sideways);
    const double lowest = std::min(inset(up, normal, error), 0.5);
    return {outward + Vec3(0, 0, std::clamp(local.z, lowest, 1 - lowest)), normal};
}

inline SurfacePoint surface(const Scene&, const ClosedCylinder& c, const RayQuery& q, double t) {
    const Affine& m = c.to_world;
    const Vec3 seen = q.ray.origin - m.origin + t * q.ray.direction;
    const Vec3 error = position_error(abs(m.origin) + reach(m.x, m.y) + abs(m.z), 0);
    const CylinderPoint p = nearest_on(c, c.to_local.vector(seen), error);
    return {m.point(p.local), error, p.normal, p.normal};
}

}  // namespace etalon
