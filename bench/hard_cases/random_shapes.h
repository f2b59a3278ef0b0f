// Random shapes of kinds with many parameters, for hard cases and for tests.
#pragma once

#include "core/numerics/random.h"
#include "core/scene/shapes.h"

namespace etalon::hard {

/// Returns a random partial surface of revolution.
Revolved random_revolved(const Affine& map, Random& random);

/// Returns a segment of a curve of a random type.
Curve random_curve(const Affine& map, Random& random);

}  // namespace etalon::hard
