#pragma once

#include "core/scene/geometry.h"

namespace etalon {

/// Returns half the diagonal of the box of everything bounded while the shutter is open; 1 if there
/// is nothing. It weights lights at infinity, and in media ends shadow rays to distant lights.
double scene_radius(const Geometry& geometry);

}  // namespace etalon
