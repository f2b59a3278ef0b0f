// Normals of shapes as files state them or as their corners imply. Each answer is the same for a
// scene scaled by a power of two.
#pragma once

#include <span>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns whether a vector is of unit length up to roundings: a step of 2^-53 in each of its
/// numbers, and those of the product.
bool is_of_unit_length(const Vec3& v);

/// Returns a vector along the normal of a polygon, on the side from which the corners run
/// counter-clockwise (Newell's sum over the fan of triangles about the first corner). Zero if they
/// span no area.
Vec3 area_normal(std::span<const Vec3> corners);

}  // namespace etalon
