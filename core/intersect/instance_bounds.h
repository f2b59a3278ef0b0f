#pragma once

#include <vector>

#include "core/intersect/outliers.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns a box of the world for each instance, which holds all that rays can hit of it at any
/// time, the roundings on their way into the object included. `others` is the box of all else that
/// is bounded. A box is empty where nothing can be hit, and infinite where the object is not
/// bounded or the roundings are not small against the scene, of which instances that reach beyond
/// `limit` are no part.
std::vector<Box3> instance_bounds(const Geometry& geometry, const Box3& others,
                                  double limit = FurthestItems::no_limit);

/// Returns the box of all primitives and instances that are bounded.
Box3 finite_bounds(const Geometry& geometry);

}  // namespace etalon
