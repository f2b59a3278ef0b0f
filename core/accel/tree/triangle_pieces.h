// Triangles cut along planes, with a box for each piece, as floats in normalized space.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/accel/tree/bounds.h"
#include "core/intersect/normalized_space.h"

namespace etalon {

/// Corners of a triangle, rounded.
using Corners = std::array<Bounds::Corner, 3>;

Corners corners_in(const NormalizedSpace& space, const std::array<Vec3, 3>& world);
Bounds bounds_of(const Corners& corners);

/// A plane of the hierarchy that recursively halves the cube of normalized space along each axis.
struct MedianPlane {
    int axis;
    float position;
};

/// Returns the first plane of the hierarchy that passes through the inside of a box; nothing if the
/// box is so small that it lies between all planes.
std::optional<MedianPlane> first_median(const Bounds& box);

/// Bound on how far boxes of pieces fall short of them on any side: 12 u where an edge crosses a
/// plane (see `cut`), 1 u for rounded corners, and some room.
inline constexpr float piece_error = 16 * unit_roundoff_f;

/// Returns the boxes of the parts of a triangle within `box` on both sides of a plane through the
/// inside of `box`, the lower side first. Where there is no part, min may be above max.
std::array<Bounds, 2> cut(const Corners& corners, const Bounds& box, const MedianPlane& plane);

/// Appends the boxes of a triangle that is cut `cuts` times; together they contain it.
void add_pieces(const Corners& corners, const Bounds& box, int cuts, std::vector<Bounds>& pieces);

}  // namespace etalon
