#pragma once

#include <span>

#include "core/intersect/shapes/edges.h"
#include "core/scene/polygon.h"

namespace etalon {

/// Returns whether all corners lie in one plane with the ray.
bool is_edge_on(std::span<const Vec3> p, const RayQuery& q);

/// Applies the even-odd rule in the sheared frame of the triangles: counts the edges that cross the
/// positive x axis, where an end on the axis counts as below it. Every sign is that of the exact
/// input, so that faces that share an edge leave no gap. The outline belongs to the polygon.
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
    double cosine;  ///< cosine of the plane's normal and the ray, up to a positive factor
};

enum class Coverage : std::uint8_t { none, full, unknown };

/// Returns what covers() returns, or that it is unknown, by several projected edges at a time, for
/// a polygon with columns. The passage is one of plain_passage(), with t >= 0.
Coverage projected_coverage(const StoredPolygon& polygon, const PlanePassage& passage,
                            const RayQuery& q);

}  // namespace etalon
