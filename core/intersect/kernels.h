// A primitive's kernels, whatever its kind. They are compiled once, in kernels.cpp, so every
// backend runs the same instructions and gets the same bits.
#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// core/intersect/shapes/all_shapes.h says what these promise.
Box3 primitive_bounds(const Geometry& geometry, std::uint32_t primitive);
double primitive_first_hit(const Geometry& geometry, std::uint32_t primitive,
                           const RayQuery& query);

/// Returns the box padded for the roundings of sums of coordinates, which may exceed the size of a
/// small shape far from the origin: up to eight roundings of each axis's largest coordinate.
Box3 widened(const Box3& box);

/// Returns a box that contains every point that can be hit. Bounds that are a shape's own numbers
/// are used as they are; where they are sums, the box is widened.
Box3 whole_bounds(const Geometry& geometry, std::uint32_t primitive);

/// Returns whether a ray that hits a primitive which is cut out does so in a hole. The kernel asks
/// this.
bool meets_hole(const Geometry& geometry, std::uint32_t primitive, const RayQuery& query);

/// The same as primitive_first_hit() for callers that have the shape itself, which saves the two
/// cache misses of looking it up by the primitive's number. Of triangles only the corners are used;
/// those that are cut out must not be given.
template <class Shape>
double shape_first_hit(const Geometry& geometry, const Shape& shape, Sides sides,
                       const RayQuery& query);
extern template double shape_first_hit(const Geometry&, const Triangle&, Sides, const RayQuery&);
extern template double shape_first_hit(const Geometry&, const Sphere&, Sides, const RayQuery&);

SurfacePoint surface_at(const Geometry& geometry, const Ray& ray, const Hit& hit);

}  // namespace etalon
