#pragma once

#include <span>

#include "core/intersect/ray.h"
#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/edges.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

inline std::span<const Vec3> corners(const Geometry& geometry, const Polygon& p) {
    return {&geometry.vertices[p.first], p.count};
}

/// The plane that a polygon is taken to lie in, even if its corners are a little off: through their
/// mean, across Newell's normal (twice the area, counter-clockwise; summed from the first corner,
/// as close to the plane as any).
struct PolygonPlane {
    Vec3 mean{0};  ///< seen from the first corner
    Vec3 normal{0};
    Vec3 terms{0};  ///< the magnitudes that the normal is a sum of
};

inline PolygonPlane plane_of(std::span<const Vec3> p) {
    PolygonPlane plane;
    for (std::size_t i = 1; i < p.size(); ++i) {
        const Vec3 a = p[i - 1] - p[0], b = p[i] - p[0];
        plane.mean += b;
        plane.normal += a.cross(b);
        const Vec3 x = abs(a), y = abs(b);
        plane.terms += Vec3(x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x);
    }
    plane.mean /= static_cast<double>(p.size());
    return plane;
}

inline bool is_degenerate(const PolygonPlane& plane) {
    return !is_finite(plane.normal) || !is_finite(plane.mean) || plane.normal == Vec3(0);
}

inline Box3 box_of(std::span<const Vec3> p) {
    Box3 box;
    for (const Vec3& corner : p) box.extendBy(corner);
    return box;
}

inline Box3 bounds(const Geometry& geometry, const Polygon& polygon) {
    const std::span<const Vec3> p = corners(geometry, polygon);
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

/// Point where a ray's line passes a polygon's plane.
struct PlanePassage {
    double t;
    double cosine;  ///< cosine of the plane's normal and the ray, but for a positive factor
};

/// Exact passage; slow. t is good to a few ulp, and NaN where the ray runs along the plane.
PlanePassage exact_passage(std::span<const Vec3> p, const RayQuery& q);

/// The side seen is the right one, and t good to t_tolerance, or certainly negative.
inline PlanePassage passage(std::span<const Vec3> p, const Vec3& size, const PolygonPlane& plane,
                            const RayQuery& q) {
    const Vec3 to_first = p[0] - q.ray.origin, &d = q.ray.direction;
    const double cosine = plane.normal.dot(d), distance = plane.normal.dot(to_first + plane.mean);
    constexpr double worst = t_tolerance / 2;
    const double roundings = 4 * (static_cast<double>(p.size()) + 8) * unit_roundoff;
    const double cosine_error_bound = roundings * plane.terms.dot(abs(d));
    const double distance_error_bound = roundings * plane.terms.dot(abs(to_first) + size);
    const bool certain =
        std::abs(cosine) > cosine_error_bound && std::abs(distance) > distance_error_bound;
    const bool good = worst * std::abs(cosine) > cosine_error_bound &&
                      worst * std::abs(distance) > distance_error_bound;
    if (good || (certain && (cosine > 0) != (distance > 0))) return {distance / cosine, cosine};
    return exact_passage(p, q);
}

/// The plane is met at t, and the hit is there, but never outside the box of the corners: where
/// they are a little off the plane, or the ray runs along it, the plane alone could carry it away.
inline double first_hit(const Geometry& geometry, const Polygon& polygon, Sides sides,
                        const RayQuery& q) {
    const std::span<const Vec3> p = corners(geometry, polygon);
    if (!covers(p, q)) return no_hit;
    const PolygonPlane plane = plane_of(p);
    if (is_degenerate(plane)) return no_hit;
    const Box3 box = box_of(p);
    const auto [t, cosine] = passage(p, box.size(), plane, q);
    if (!faces(cosine, sides) || !(t > q.ray.tmin)) return no_hit;
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

inline SurfacePoint surface(const Geometry& geometry, const Polygon& polygon, const RayQuery& q,
                            double t) {
    const std::span<const Vec3> p = corners(geometry, polygon);
    const PolygonPlane plane = plane_of(p);
    const Vec3 normal = normalized(plane.normal);
    Vec3 position = q.ray.origin + t * q.ray.direction;
    const Vec3 point = p[0] + plane.mean;
    position -= normal.dot(position - point) * normal;

    Vec3 shading = normal;
    if (polygon.normals != no_index) {
        const Vec3 mean =
            interpolated_normal(p, &geometry.normals[polygon.normals], normal, position);
        const double length2 = mean.dot(mean);
        if (length2 > 0 && length2 < infinity) shading = mean / std::sqrt(length2);
    }
    const Box3 box = box_of(p);
    const Vec3 size = box.size();
    return {position, position_error(abs(point) + size, max_abs(size)), normal, shading};
}

/// Lengths in the plane, from the first corner: see plane_chart(). dpdu x dpdv is the unit normal.
inline Parametrization parametrization(const Geometry& geometry, const Polygon& polygon,
                                       const SurfacePoint& p) {
    return plane_chart(p.normal, p.position - corners(geometry, polygon)[0]);
}

}  // namespace etalon
