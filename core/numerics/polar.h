#pragma once

#include "core/numerics/affine.h"

namespace etalon {

/// A linear map as a rotation after a stretch. The stretch is symmetric but for roundings; it
/// mirrors where the map does.
struct PolarParts {
    Affine rotation, stretch;
};

/// Returns the rotation that is nearest to the linear part of a map that is not singular, and what
/// the map does before it (Shoemake & Duff 1992, "Matrix Animation and Polar Decomposition"). Not
/// finite for a map that is singular or not finite. The origin is left out.
PolarParts polar_parts(const Affine& map);

}  // namespace etalon
