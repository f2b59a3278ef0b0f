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

/// Constants of the bounds that polygon_outline.cpp derives.
struct OutlineBounds {
    static constexpr double of_passage = 2 * t_tolerance, of_corners = 1.01;
    static constexpr double of_point = 4 * unit_roundoff, of_roundings = 16 * unit_roundoff;
    static constexpr double of_side = 8;             ///< per error of a coordinate
    static constexpr double largest_error = 0x1p-6;  ///< of a coordinate for which they hold
    static constexpr double least_cosine =
        0x1p-900;  ///< below, products that underflow could matter
};

/// Returns what covers() returns, or that it is unknown, by several projected edges at a time, for
/// a polygon with columns. The passage is one of plain_passage(), with t >= 0.
Coverage projected_coverage(const StoredPolygon& polygon, const PlanePassage& passage,
                            const RayQuery& q);

}  // namespace etalon
