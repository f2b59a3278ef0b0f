#pragma once

#include "core/intersect/near_region.h"
#include "core/intersect/normalized_space.h"
#include "core/parallel/large_pages.h"
#include "core/scene/geometry.h"

namespace etalon {

struct InstanceBounds {
    LargeVector<Box3> boxes;  ///< boxes in world space, one for each instance
    double spread = 1;        ///< largest component of spread() of all bounded instances
    /// How far outside of their boxes rays that a space resolves may hit instances, as a fraction
    /// of the scene's half size.
    double drift = 0;
};

/// Returns a box in world space for each instance. It contains all points that rays can hit at any
/// time, including the roundings of the transform into object space. `others` is the box of all
/// bounded primitives. A box is empty where nothing can be hit. It is infinite where the object is
/// unbounded, or where the roundings are not small against the scene; instances outside of `near`
/// do not count as part of the scene. Boxes with least_padding are for rays that start next to the
/// scene: a ray from further away may hit points outside of a box by up to 2^-50 of its distance
/// times the largest spread.
InstanceBounds instance_bounds(const Geometry& geometry, const Box3& others,
                               const NearRegion& near = {},
                               const InstancePadding& padding = full_padding);

/// Returns the box of all bounded primitives and instances.
Box3 finite_bounds(const Geometry& geometry);

}  // namespace etalon
