#pragma once

#include <vector>

#include "core/intersect/normalized_space.h"
#include "core/intersect/outliers.h"
#include "core/scene/geometry.h"

namespace etalon {

struct InstanceBounds {
    std::vector<Box3> boxes;  ///< of the world, one for each instance
    double spread = 1;        ///< the largest component of spread() of all that are bounded
};

/// Returns a box of the world for each instance, which holds all that rays can hit of it at any
/// time, the roundings on their way into the object included. `others` is the box of all else that
/// is bounded. A box is empty where nothing can be hit, and infinite where the object is not
/// bounded or the roundings are not small against the scene, of which instances that reach beyond
/// `limit` are no part. With least_padding, rays from next to the scene are provided for; those
/// from further hit what is outside of a box by up to 2^-50 of their distance times the largest
/// spread.
InstanceBounds instance_bounds(const Geometry& geometry, const Box3& others,
                               double limit = FurthestItems::no_limit,
                               const InstancePadding& padding = full_padding);

/// Returns the box of all primitives and instances that are bounded.
Box3 finite_bounds(const Geometry& geometry);

}  // namespace etalon
