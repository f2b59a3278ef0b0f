#pragma once

#include "core/scene/geometry.h"

namespace etalon::bench {

/// Returns the geometry with each instance replaced by a copy of its object, up to the rounding of
/// vertices: the baseline for instances. Objects must consist of triangles; other shapes are left
/// out of the copies.
Geometry flattened(const Geometry& geometry);

}  // namespace etalon::bench
