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
    /// Bounds on the errors of the normal's components, with eight roundings of each: the sign of
    /// `normal . v` is sure if that exceeds `error . |v|`.
    Vec3 error{0};
};

/// Sums in double-double, or exactly where that cancels, so that the errors do not grow with the
/// number of corners: a ray that leaves the polygon starts only a few roundings above it. The
/// normal is zero or not finite if there is none.
PolygonPlane plane_of(std::span<const Vec3> corners);

/// The projection of a polygon's outline along the dominant axis of its normal, for kernels that
/// test several edges at once: x along the axis after that one and y along the next, both in [0,
/// 1].
struct OutlineProjection {
    int x_axis() const { return (along + 1) % 3; }
    int y_axis() const { return (along + 2) % 3; }

    int along = 0;
    Vec2 scale{0};                ///< 1 / the sizes of the corners' box
    double off_plane = infinity;  ///< bound on normal . (corner - mean) of all corners
};

/// Sums over all corners, computed once instead of at every hit.
struct PolygonFacts {
    PolygonFacts() = default;
    explicit PolygonFacts(std::span<const Vec3> corners);

    PolygonPlane plane;
    Box3 box;  ///< box of the corners; empty for a degenerate polygon, which has no plane
    OutlineProjection projection;
};

/// The projected corners in SoA layout. A column begins with the last corner, so that every edge
/// goes from one number to the next; then come all corners, and copies of the last up to a multiple
/// of `lanes`, and one more.
struct OutlineColumns {
    static constexpr std::size_t lanes = 4;

    const double *x = nullptr, *y = nullptr;
    std::size_t edges = 0;  ///< a multiple of `lanes`
};

/// A polygon as a geometry keeps it.
struct StoredPolygon : Polygon {
    const PolygonFacts& facts;
    OutlineColumns columns;
};

}  // namespace etalon
