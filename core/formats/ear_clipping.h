#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the corners of the count - 2 triangles of a polygon that does not cross itself, by ear
/// clipping (Meisters 1975, "Polygons Have Ears"). The outline runs counter-clockwise; cuts to
/// holes may repeat corners. A polygon that crosses itself is covered only approximately.
std::vector<std::array<std::uint32_t, 3>> clip_ears(const std::vector<Vec2>& outline);

}  // namespace etalon
