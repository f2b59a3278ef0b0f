#pragma once

#include <optional>
#include <span>

#include "core/intersect/ray.h"
#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/polygon_outline.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

inline Box3 bounds(const Geometry&, const StoredPolygon& polygon) {
    return polygon.facts.box;
}

/// Computes the passage exactly; slow. t is good to a few ulp, and NaN where the ray runs along the
/// plane.
PlanePassage exact_passage(std::span<const Vec3> p, const RayQuery& q);

/// Returns the passage if plain doubles suffice, else nothing. Then the side seen is right, and t
/// is good to t_tolerance or certainly negative.
///
/// For a normal n that is off by e, n . v with v exact is off by (3 u |n| + e) . |v|. The vector to
/// the mean is off by 2 u |p0 - o| and, as the mean of the corners is within their size s, by 3 u s
/// more. So both products are off by no more than (6 u |n| + e) . (|p0 - o| + s) and (3 u |n| + e)
/// . |d|, which PolygonPlane::error exceeds. What products lose that underflow is less than its
/// least component times a direction or a size that is not tiny (see RescaledRay).
inline std::optional<PlanePassage> plain_passage(const StoredPolygon& polygon, const RayQuery& q) {
    const std::span<const Vec3> p = polygon.corners;
    const PolygonPlane& plane = polygon.facts.plane;
    const Vec3 to_first = p[0] - q.ray.origin, &d = q.ray.direction;
    const double cosine = plane.normal.dot(d), distance = plane.normal.dot(to_first + plane.mean);
    constexpr double worst = t_tolerance / 2;
    const double cosine_error_bound = plane.error.dot(abs(d));
    const double distance_error_bound = plane.error.dot(abs(to_first) + polygon.facts.box.size());
    const bool certain =
        std::abs(cosine) > cosine_error_bound && std::abs(distance) > distance_error_bound;
    const bool good = worst * std::abs(cosine) > cosine_error_bound &&
                      worst * std::abs(distance) > distance_error_bound;
    if (good || (certain && (cosine > 0) != (distance > 0)))
        return PlanePassage{distance / cosine, cosine};
    return std::nullopt;
}

/// Returns whether a ray that passes the polygon's plane hits the polygon.
inline bool covers(const StoredPolygon& p, const std::optional<PlanePassage>& plain,
                   const RayQuery& q) {
    if (plain && p.columns.edges != 0) {
        const Coverage coverage = projected_coverage(p, *plain, q);
        if (coverage != Coverage::unknown) return coverage == Coverage::full;
    }
    return covers(p.corners, q);
}

/// The hit is where the ray meets the plane, but never outside the box of the corners: where they
/// are not quite in the plane, or the ray runs along it, the plane's t could be far away.
inline double first_hit(const Geometry&, const StoredPolygon& p, Sides sides, const RayQuery& q) {
    const auto is_seen = [&](const PlanePassage& passage) {
        return faces(passage.cosine, sides) && passage.t > q.ray.tmin;
    };
    const Box3& box = p.facts.box;
    if (box.isEmpty()) return no_hit;
    const std::optional<PlanePassage> plain = plain_passage(p, q);
    if ((plain && !is_seen(*plain)) || !covers(p, plain, q)) return no_hit;
    const PlanePassage passage = plain ? *plain : exact_passage(p.corners, q);
    if (!is_seen(passage)) return no_hit;
    const double t = passage.t;
    const SlabCrossing c = cross_slabs({box.min, box.max}, q.ray);
    const double first = std::min(c.entry, c.exit), last = std::max(c.entry, c.exit);
    const double kept = t > first ? std::min(t, last) : first;
    return is_ahead(kept, q.ray.tmin) ? kept : no_hit;
}

/// Returns the mean of the corners' normals at `position` by mean value coordinates, which also
/// hold for concave polygons and on their edges and corners (Hormann & Floater 2006, ACM TOG
/// 25(4)). Zero where the normals cancel.
inline Vec3 interpolated_normal(std::span<const Vec3> p, std::span<const Vec3> normals,
                                const Vec3& up, const Vec3& position) {
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

inline SurfacePoint surface(const Geometry&, const StoredPolygon& p, const RayQuery& q, double t) {
    const PolygonPlane& plane = p.facts.plane;
    const Box3& box = p.facts.box;
    const Vec3 normal = normalized(plane.normal);
    Vec3 position = q.ray.origin + t * q.ray.direction;
    const Vec3 point = p.corners[0] + plane.mean;
    position -= normal.dot(position - point) * normal;

    Vec3 shading = normal;
    if (!p.normals.empty()) {
        const Vec3 mean = interpolated_normal(p.corners, p.normals, normal, position);
        const double length2 = mean.dot(mean);
        if (length2 > 0 && length2 < infinity) shading = mean / std::sqrt(length2);
    }
    const Vec3 size = box.size();
    return {position, position_error(abs(point) + size, max_abs(size)), normal, shading};
}

/// Returns lengths in the plane, from the first corner: see plane_chart(). dpdu x dpdv is the unit
/// normal.
inline Parametrization parametrization(const Geometry&, const StoredPolygon& polygon,
                                       const SurfacePoint& p) {
    return plane_chart(p.normal, p.position - polygon.corners[0]);
}

}  // namespace etalon
