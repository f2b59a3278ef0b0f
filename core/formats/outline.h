// The outline of a polygon in the plane.
#pragma once

#include <span>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the corners projected along the axis nearest to the normal, counter-clockwise.
std::vector<Vec2> projected_outline(std::span<const Vec3> corners);

/// Returns whether two edges cross, each at a point between its ends. The time is bounded: a
/// crossing may be missed among thousands of edges whose bounding boxes mostly overlap.
bool crosses_itself(const std::vector<Vec2>& outline);

}  // namespace etalon
