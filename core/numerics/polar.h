#pragma once

#include "core/numerics/affine.h"

namespace etalon {

/// A linear map as a stretch followed by a rotation. The stretch is symmetric up to roundings; it
/// mirrors if the map does.
struct PolarParts {
    Affine rotation, stretch;
};

/// Returns the rotation nearest to the linear part of a map, and the stretch before it (Shoemake &
/// Duff 1992, "Matrix Animation and Polar Decomposition"). Not finite for a map that is singular or
/// not finite. The origin is left out.
PolarParts polar_parts(const Affine& map);

}  // namespace etalon
