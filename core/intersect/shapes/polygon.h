#pragma once

#include <span>

#include "core/intersect/ray.h"
#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/edges.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

inline std::span<const Vec3> corners(const Scene& scene, const Polygon& p) {
    return {&scene.vertices[p.first], p.count};
}

/// The plane that a polygon is taken to lie in, even if its corners are a little off: through their
/// mean, across Newell's normal (twice the area, counter-clockwise; summed from the first corner,
/// as close to the plane as any).
struct PolygonPlane {
    Vec3 point{0}, normal{0};
};

inline PolygonPlane plane_of(std::span<const Vec3> p) {
    PolygonPlane plane;
    Vec3 sum(0);
    for (std::size_t i = 1; i < p.size(); ++i) {
        sum += p[i] - p[0];
        plane.normal += (p[i - 1] - p[0]).cross(p[i] - p[0]);
    }
    plane.point = p[0] + sum / static_cast<double>(p.size());
    return plane;
}

inline bool is_degenerate(const PolygonPlane& plane) {
    return !is_finite(plane.normal) || !is_finite(plane.point) || plane.normal == Vec3(0);
}

inline Box3 box_of(std::span<const Vec3> p) {
    Box3 box;
    for (const Vec3& corner : p) box.extendBy(corner);
    return box;
}

inline Box3 bounds(const Scene& scene, const Polygon& polygon) {
    const std::span<const Vec3> p = corners(scene, polygon);
    return is_degenerate(plane_of(p)) ? Box3() : box_of(p);
}

/// Whether all corners lie in one plane with the ray.
inline bool is_edge_on(std::span<const Vec3> p, const RayQuery& q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (exact_edge_function(p[i], p[(i + 1) % p.size()], q) != 0) return false;
    }
    return true;
}

/// Even-odd rule in the sheared frame of the triangles: counts the edges that cross the positive x
/// axis, an end on the axis counting as below it. Every sign is that of the exact input, so that
/// faces that share an edge leave no gap; the outline itself belongs to the polygon.
inline bool covers(std::span<const Vec3> p, const RayQuery& q) {
    bool inside = false;
    OutlineCorner a(p.back(), q);
    for (const Vec3& corner : p) {
        const OutlineCorner b(corner, q);
        if ((a.y > 0) != (b.y > 0)) {
            const double side = edge_side(a, b, q);
            if (side == 0) return !is_edge_on(p, q);
            if ((side > 0) == (b.y > 0)) inside = !inside;
        } else if (b.y == 0 && (b.x == 0 || (a.y == 0 && (a.x > 0) != (b.x > 0)))) {
            return !is_edge_on(p, q);
        }
        a = b;
    }
    return inside;
}

/// Whether a ray runs so nearly along the plane that where it meets it is a matter of rounding.
inline bool is_along(const PolygonPlane& plane, const Vec3& direction, double cosine) {
    return std::abs(cosine) <= 0x1p-40 * abs(plane.normal).dot(abs(direction));
}

/// The plane is met at t, and the hit is there, but never outside the box of the corners: where
/// they are a little off the plane, or the ray runs along it, the plane alone could carry it away.
inline double first_hit(const Scene& scene, const Polygon& polygon, Sides sides,
                        const RayQuery& q) {
    const std::span<const Vec3> p = corners(scene, polygon);
    if (!covers(p, q)) return no_hit;
    const PolygonPlane plane = plane_of(p);
    const double cosine = plane.normal.dot(q.ray.direction);
    if (is_degenerate(plane) || !faces(cosine, sides)) return no_hit;
    const double t = plane.normal.dot(plane.point - q.ray.origin) / cosine;
    if (!is_ahead(t, q.ray.tmin) && !is_along(plane, q.ray.direction, cosine)) return no_hit;
    const Box3 box = box_of(p);
    const SlabCrossing c = cross_slabs({box.min, box.max}, q.ray);
    const double first = std::min(c.entry, c.exit), last = std::max(c.entry, c.exit);
    const double kept = t > first ? std::min(t, last) : first;
    return is_ahead(kept, q.ray.tmin) ? kept : no_hit;
}

/// The mean of the corners' normals at `position`, by mean value coordinates, which hold for
/// concave polygons too, and on their edges and corners (Hormann & Floater 2006, ACM TOG 25(4)).
/// Zero where the normals cancel.
inline Vec3 interpolated_normal(std::span<const Vec3> p, const Vec3* normals, const Vec3& up,
                                const Vec3& position) {
    const std::size_t n = p.size();
    Vec3 sum(0);
    double weights = 0;
    for (std::size_t i = 0, j = 1; i < n; ++i, j = (i + 1) % n) {
        const Vec3 a = p[i] - position, b = p[j] - position;
        const double ra = std::sqrt(a.dot(a)), rb = std::sqrt(b.dot(b));
        if (ra == 0) return normals[i];
        if (rb == 0) return normals[j];
        const double sine = up.dot(a.cross(b)), cosine = a.dot(b);
        if (sine == 0 && cosine < 0) return rb * normals[i] + ra * normals[j];
        // The tangent of half the angle, by whichever form does not cancel.
        const double tangent = cosine >= 0 ? sine / (ra * rb + cosine) : (ra * rb - cosine) / sine;
        sum += tangent * (normals[i] / ra + normals[j] / rb);
        weights += tangent * (1 / ra + 1 / rb);
    }
    return weights < 0 ? -sum : sum;
}

inline SurfacePoint surface(const Scene& scene, const Polygon& polygon, const RayQuery& q,
                            double t) {
    const std::span<const Vec3> p = corners(scene, polygon);
    const PolygonPlane plane = plane_of(p);
    const Vec3 normal = plane.normal / std::sqrt(plane.normal.dot(plane.normal));
    Vec3 position = q.ray.origin + t * q.ray.direction;
    position -= normal.dot(position - plane.point) * normal;

    Vec3 shading = normal;
    if (polygon.normals != no_index) {
        const Vec3 mean = interpolated_normal(p, &scene.normals[polygon.normals], normal, position);
        const double length2 = mean.dot(mean);
        if (length2 > 0 && length2 < infinity) shading = mean / std::sqrt(length2);
    }
    const Box3 box = box_of(p);
    const Vec3 size = box.size();
    return {position, position_error(abs(plane.point) + size, max_abs(size)), normal, shading};
}

}  // namespace etalon
