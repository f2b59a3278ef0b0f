// Triangles cut along planes, each piece with a box of its own, in floats of normalized space.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/accel/tree/bounds.h"
#include "core/intersect/normalized_space.h"

namespace etalon {

/// A triangle's, rounded.
using Corners = std::array<Bounds::Corner, 3>;

Corners corners_in(const NormalizedSpace& space, const std::array<Vec3, 3>& world);
Bounds bounds_of(const Corners& corners);

/// A plane of the hierarchy that halves normalized space's cube along each axis again and again.
struct MedianPlane {
    int axis;
    float position;
};

/// The first of the hierarchy that passes through the inside of a box; nothing for one so small
/// that it lies between them all.
std::optional<MedianPlane> first_median(const Bounds& box);

/// Bound on how far boxes of pieces fall short of them on any side: 12 u where an edge passes a
/// plane (see `cut`), 1 u for corners that were rounded, and room.
inline constexpr float piece_error = 16 * unit_roundoff_f;

/// Boxes of what a triangle has within `box` on both sides of a plane through the inside of `box`,
/// below it first. Where it has nothing, min may be above max.
std::array<Bounds, 2> cut(const Corners& corners, const Bounds& box, const MedianPlane& plane);

/// Adds the boxes of a triangle cut so many times: together they hold it.
void add_pieces(const Corners& corners, const Bounds& box, int cuts, std::vector<Bounds>& pieces);

}  // namespace etalon
