// Polygons: their corners, and properties of all corners that kernels need.
#pragma once

#include <span>
#include <string_view>

#include "core/numerics/vec.h"
#include "core/scene/convexity.h"

namespace etalon {

/// A planar polygon with at least 4 corners, concave or not. The front is where the corners run
/// counter-clockwise. It does not own the spans; a geometry keeps copies.
struct Polygon {
    static constexpr std::string_view name = "polygon";
    static constexpr Convexity convexity = Convexity::any;  // corners may lie off their plane
    std::span<const Vec3> corners;
    std::span<const Vec3> normals = {};  ///< one for each corner, or none
};

/// The plane in which a polygon is taken to lie, even if its corners are slightly off it: through
/// their mean and perpendicular to Newell's normal (twice the area, counter-clockwise; summed from
/// the first corner, which is as close to the plane as any).
struct PolygonPlane {
    Vec3 mean{0};  ///< relative to the first corner
    Vec3 normal{0};
    Vec3 terms{0};  ///< sums of the magnitudes of the normal's terms
};

PolygonPlane plane_of(std::span<const Vec3> corners);

/// Sums over all corners, computed once instead of at every hit.
struct PolygonFacts {
    PolygonFacts() = default;
    explicit PolygonFacts(std::span<const Vec3> corners);

    PolygonPlane plane;
    Box3 box;  ///< box of the corners; empty for a degenerate polygon, which has no plane
};

/// The corners in SoA layout, one column for each axis. A column begins with the last corner, so
/// that every edge goes from one number to the next; then come all corners, and copies of the last
/// up to a multiple of `lanes`.
struct CornerColumns {
    static constexpr std::size_t lanes = 4;

    const double* along(int axis) const { return first + static_cast<std::size_t>(axis) * length; }

    const double* first = nullptr;
    std::size_t length = 0;  ///< of a column; 0 where the polygon has too few corners for columns
};

/// A polygon as a geometry keeps it.
struct StoredPolygon : Polygon {
    const PolygonFacts& facts;
    CornerColumns columns;
};

}  // namespace etalon
