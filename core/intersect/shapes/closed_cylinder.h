#pragma once

#include "core/intersect/shapes/affine_exact.h"
#include "core/intersect/shapes/affine_surface.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/closed_cylinder_fast.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns the box of the two caps' circles.
inline Box3 bounds(const Geometry&, const ClosedCylinder& c) {
    if (!c.frame.exists()) return {};
    const Affine& m = c.to_world;
    Box3 centres;
    centres.extendBy(m.origin);
    centres.extendBy(m.origin + m.z);
    return box_around(centres.min, centres.max, reach(m.x, m.y));
}

/// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain.
inline double fast_path(const ClosedCylinder& c, Sides sides, const RayQuery& q) {
    return ClosedCylinderFastPath(c, q).first_hit(sides);
}

/// Returns the first visible t. Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Geometry&, const ClosedCylinder& c, Sides sides, const RayQuery& q) {
    const double t = fast_path(c, sides, q);
    if (t != uncertain) return t;
    const Passage x = exact_passage(c, q.ray);
    return first_visible(x.entry, x.exit, sides, q.ray.tmin);
}

/// A point of the surface in local coordinates, and its normal in the world.
struct CylinderPoint {
    Vec3 local, normal;
};

/// Returns a bound on the error of a coordinate with this gradient at the origin of a ray that
/// leaves a point.
inline double inset(const Vec3& gradient, const Vec3& normal, const Vec3& error) {
    const double offset = std::abs(gradient.dot(normal)) * abs(normal).dot(error);
    return 2 * (offset + abs(gradient).dot(error));
}

/// Moves a point onto a cap. Next to a rim the point is moved along its face, so that a ray that
/// goes inward from there starts inside.
inline CylinderPoint on_cap(const ClosedCylinder& c, const Vec3& local, double cap,
                            const Vec3& error) {
    const Vec3 side = outward(local);
    const Vec3 normal = unit_vector((cap == 0 ? -1.0 : 1.0) * c.frame.row(2));
    const double widest = std::max(1 - inset(c.frame.normal(side), normal, error), 0.0);
    const double radius = std::min(std::hypot(local.x, local.y), widest);
    return {radius * side + Vec3(0, 0, cap), normal};
}

inline CylinderPoint on_side(const ClosedCylinder& c, const Vec3& local, const Vec3& error) {
    const Vec3 side = outward(local), normal = unit_vector(c.frame.normal(side));
    const double lowest = std::min(inset(c.frame.row(2), normal, error), 0.5);
    return {side + Vec3(0, 0, std::clamp(local.z, lowest, 1 - lowest)), normal};
}

/// Returns the point on the side or on a cap, whichever is nearer in world space.
inline CylinderPoint nearest_on(const ClosedCylinder& c, const Vec3& seen, const Vec3& error) {
    const Vec3 local = c.frame.vector(seen);
    const Vec3 up = c.frame.row(2), sideways = c.frame.normal(outward(local));
    const double cap = local.z < 0.5 ? 0 : 1;
    const double above_cap = local.z - cap, off_side = std::hypot(local.x, local.y) - 1;
    const auto moved = [&](const Vec3& gradient, double value) {
        return c.frame.vector(moved_onto_surface(seen, gradient, value));
    };
    if (std::abs(above_cap) * max_abs(sideways) < std::abs(off_side) * max_abs(up)) {
        return on_cap(c, moved(up, above_cap), cap, error);
    }
    return on_side(c, moved(sideways, off_side), error);
}

inline SurfacePoint surface(const Geometry&, const ClosedCylinder& c, const RayQuery& q, double t) {
    const Affine& m = c.to_world;
    const Vec3 seen = q.ray.origin - m.origin + t * q.ray.direction;
    const Vec3 error = position_error(abs(m.origin) + reach(m.x, m.y) + abs(m.z), 0);
    const CylinderPoint p = nearest_on(c, seen, error);
    return {c.frame.point(p.local), error, p.normal, p.normal};
}

inline bool is_on_cap(const ClosedCylinder& c, const SurfacePoint& p) {
    const Vec3 normal = pulled_back(c.to_world, p.normal);
    return std::abs(normal.z) > std::hypot(normal.x, normal.y);
}

/// Moves a point of a cap or of the side along it, away from the rims by `distance` and its own
/// error if there is room. Returns whether it was moved.
inline bool move_off_edges(const ClosedCylinder& c, const Vec3& distance, SurfacePoint& p) {
    const Vec3 local = c.frame.vector(p.position - c.to_world.origin), side = outward(local);
    const Vec3 reach = distance + p.error;
    if (is_on_cap(c, p)) {
        const double widest = std::max(1 - abs(c.frame.normal(side)).dot(reach), 0.0);
        if (std::hypot(local.x, local.y) <= widest) return false;
        p.position = c.frame.point(widest * side + Vec3(0, 0, local.z < 0.5 ? 0 : 1));
    } else {
        const double lowest = std::min(abs(c.frame.row(2)).dot(reach), 0.5);
        if (lowest <= local.z && local.z <= 1 - lowest) return false;
        p.position = c.frame.point(side + Vec3(0, 0, std::clamp(local.z, lowest, 1 - lowest)));
    }
    return true;
}

/// Returns coordinates across the axis in the unit cylinder. The frame's own are rotated about it.
inline Vec3 unturned(const ClosedCylinder& c, const Vec3& local) {
    const Vec3 x = c.frame.vector(c.to_world.x), y = c.frame.vector(c.to_world.y);
    return {local.x * x.x + local.y * x.y, local.x * y.x + local.y * y.y, 0};
}

/// Returns the image of the unit cylinder's parametrization. The side has that of pbrt's cylinder,
/// either cap that of pbrt's disk. There dpdu x dpdv points outward on the side, and along +z on
/// both caps; a mirroring map reverses it.
inline Parametrization parametrization(const Geometry&, const ClosedCylinder& c,
                                       const SurfacePoint& p) {
    const Vec3 local = c.frame.vector(p.position - c.to_world.origin);
    if (is_on_cap(c, p)) return image(c.to_world, ring_chart(unturned(c, local), 0, 1));
    const Vec3 normal = pulled_back(c.to_world, p.normal);
    return image(c.to_world, cone_chart(outward(normal), saturated(local.z), 1, 1, 1));
}

}  // namespace etalon
