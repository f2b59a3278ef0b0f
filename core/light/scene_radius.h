#pragma once

#include "core/scene/geometry.h"

namespace etalon {

/// Returns half the diagonal of the box of everything bounded, when the shutter opens; 1 if there
/// is nothing. It only weights lights at infinity, which needs no more precision.
double scene_radius(const Geometry& geometry);

}  // namespace etalon
