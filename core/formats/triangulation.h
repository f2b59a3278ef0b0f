#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the corners of the count - 2 triangles of a planar polygon, concave or not, in its
/// winding order: a fan about the first corner if that is correct. A polygon that crosses itself is
/// covered only approximately.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace etalon
