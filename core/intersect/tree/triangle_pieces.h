// Triangles cut along planes, each piece with a box of its own.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/intersect/frame.h"

namespace etalon {

using Corners = std::array<Vec3, 3>;

/// A plane of the hierarchy that halves the frame's cube along each axis again and again.
struct MedianPlane {
    int axis;
    double position;  ///< in the world
    int level;        ///< 0 for the middle of the cube
};

/// The first of the hierarchy that passes through the inside of a box; nothing for one so small
/// that it lies between them all.
std::optional<MedianPlane> first_median(const Box3& world, const Frame& frame);

/// Boxes of what a triangle has within `box` on both sides of a plane, below it first: no smaller
/// than that whatever the roundings. Empty where it has nothing.
std::array<Box3, 2> cut(const Corners& corners, const Box3& box, const MedianPlane& plane);

/// Adds the boxes of a triangle cut so many times. Each contains its piece, all together the
/// triangle. Its edges must be finite.
void add_pieces(const Corners& corners, const Box3& box, int cuts, const Frame& frame,
                std::vector<Box3>& pieces);

}  // namespace etalon
