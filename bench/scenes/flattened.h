#pragma once

#include "core/scene/geometry.h"

namespace etalon::bench {

/// Returns the geometry with a copy of its object in the place of each instance, to the rounding of
/// vertices: what instances are measured against. Objects must be of triangles alone, as others are
/// left out of the copies.
Geometry flattened(const Geometry& geometry);

}  // namespace etalon::bench
