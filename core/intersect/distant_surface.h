// Points of hits by rays from very far away. In o + t d - c, where c is the shape's centre, the
// roundings of o and t d remain: from 2^53 sizes of the shape away they are as large as the shape.
#pragma once

#include "core/intersect/shapes/thickness.h"
#include "core/intersect/surface.h"

namespace etalon {

/// Returns what surface() would without those roundings, for a hit at `t` that is_distant(). Finds
/// the hit a second time; slow.
template <HasThickness Shape>
SurfacePoint distant_surface(const Geometry& geometry, const Shape& shape, Sides sides,
                             const Ray& ray, double t);

}  // namespace etalon
