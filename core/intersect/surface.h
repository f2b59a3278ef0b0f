#pragma once

#include "core/intersect/ray.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// Position of a hit on a curve, which the point alone does not determine.
struct PlaceOnCurve {
    double u = 0, v = 0;
    double width = 0;  ///< as the ray saw it, in the curve's own space
};

/// Point where a ray hit a surface, refined so that it lies on the surface.
struct SurfacePoint {
    Vec3 position;
    /// Error bound of the position for each axis, relative to the true surface as the kernel sees
    /// it: a ray that starts further out than this does not hit the surface that it left.
    Vec3 error;
    Vec3 normal;          ///< geometric, unit, as the shape defines it (outward, or by winding)
    Vec3 shading_normal;  ///< unit; interpolated where the shape has corner normals
    std::uint32_t primitive = no_index;
    std::uint32_t material = no_index;     ///< number among the materials of the scene's look
    Convexity convexity = Convexity::any;  ///< convexity of the primitive
    std::uint32_t instance = no_index;     ///< instance of which the primitive is a part, if any
    ShutterTime time = 0;                  ///< time of the ray that hit it
    PlaceOnCurve on_curve{};
};

/// Returns the error bound that kernels use. To round the position and to evaluate the kernel takes
/// a few dozen roundings of quantities no larger than these; 64 leaves room for all of them.
inline Vec3 position_error(const Vec3& magnitude, double extent) {
    return 64 * unit_roundoff * (magnitude + Vec3(extent));
}

/// Returns the side of the surface to which a ray leaves: 1 for that of the normal, else -1.
inline double side_of(const SurfacePoint& p, const Vec3& direction) {
    return p.normal.dot(direction) < 0 ? -1.0 : 1.0;
}

/// Returns the origin of a ray that leaves `p` in `direction`. It is offset along the geometric
/// normal, to the direction's side, by the error bound projected on the normal; each coordinate is
/// then rounded away from the surface (Pharr, Jakob & Humphreys 2016, section 3.9.5).
inline Vec3 spawn_origin(const SurfacePoint& p, const Vec3& direction) {
    const double distance = abs(p.normal).dot(p.error);
    const Vec3 offset = side_of(p, direction) * distance * p.normal;
    Vec3 origin = p.position + offset;
    for (int k = 0; k < 3; ++k) {
        if (offset[k] != 0) origin[k] = next_towards(origin[k], offset[k]);
    }
    return origin;
}

/// Returns a ray that leaves `p`, at the time of `p`.
inline Ray spawn_ray(const SurfacePoint& p, const Vec3& direction) {
    const bool outward = p.normal.dot(direction) > 0;
    const bool for_good =
        p.convexity == Convexity::flat || (p.convexity == Convexity::convex && outward);
    const HitKey exclude = for_good ? exclusion_of(p.primitive, p.instance) : no_index;
    return {spawn_origin(p, direction), direction, 0, infinity, exclude, p.time << Ray::time_shift};
}

/// Returns the continuation of a ray that passes through the surface of `hit`. It hits a surface
/// that coincides with a flat one, such as a floor under one that is full of holes. Of more than
/// two coincident surfaces it may miss some.
inline Ray ray_beyond(const Ray& ray, const Hit& hit, Convexity convexity) {
    Ray rest = ray;
    const double before = std::nextafter(hit.t, 0.0);
    const HitKey key = exclusion_of(hit.primitive, hit.instance);
    const bool is_in_order = key != no_index && (ray.tmin != before || ray.exclude < key);
    if (convexity == Convexity::flat && is_in_order) {
        rest.tmin = before;
        rest.exclude = key;
    } else {
        // A backend of single precision may find the same hit again.
        rest.tmin = hit.t > ray.tmin ? hit.t : ray.tmin * (1 + 0x1p-20);
        rest.exclude = no_index;
    }
    return rest;
}

/// Returns a ray that leaves `p` and reaches a target at t = 1. If the target is nearer than the
/// offset of the origin, it lies behind the origin.
inline Ray spawn_ray_to(const SurfacePoint& p, const Vec3& target) {
    const Vec3 towards = target - p.position;
    Ray ray = spawn_ray(p, towards);
    ray.direction = target - ray.origin;
    ray.tmax = 1;
    const bool moves_away = side_of(p, towards) * p.normal.dot(ray.direction) > 0;
    if (!moves_away) ray.exclude = no_index;
    return ray;
}

}  // namespace etalon
