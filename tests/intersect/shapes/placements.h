// Positions of shapes in tests: aligned with nothing by accident, and far away.
#pragma once

#include "core/numerics/affine.h"
#include "core/numerics/random.h"

namespace etalon {

inline const Vec3 base{0.3, -0.7, 0.45}, far_away{148376, 1234, -223423};

/// Returns a point in a frame that is aligned with no axis.
Vec3 tilted(double x, double y, double z);

/// Returns that frame, at `base`.
Affine rotation();

Affine scaling(double x, double y, double z);

/// Returns the cube about a point.
Box3 around(const Vec3& centre, double reach);

/// Returns a factor that moves a surface in or out by a random amount, from far below a rounding to
/// visible.
double nearly_one(Random& random);

}  // namespace etalon
