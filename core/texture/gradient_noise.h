#pragma once

#include "core/numerics/vec_columns.h"

namespace etalon {

/// Returns a smooth function of a point within [-1, 1] that is 0 at all points with integer
/// coordinates: Perlin 2002, "Improving Noise", with pbrt-v3's gradients. 0 if the point is not
/// finite.
double gradient_noise(const Vec3& p);

/// Sets the values at `count` points, several at a time. Both columns are padded.
void gradient_noise(const Vec3Span& points, std::size_t count, double* values);

}  // namespace etalon
