#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Returns a smooth function of a point that is 0 at all points of whole numbers, within [-1, 1]:
/// Perlin 2002, "Improving Noise", with pbrt-v3's gradients. 0 where the point is not finite.
double gradient_noise(const Vec3& p);

}  // namespace etalon
