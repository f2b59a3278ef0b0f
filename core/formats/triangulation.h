#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// The numbers of the corners of count - 2 triangles that make up a polygon in a plane, concave or
/// not, in its turning sense: a fan about the first corner where that will do. One that crosses
/// itself, or is no fan and has more than 4096 corners, is only covered as well as can be.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace etalon
