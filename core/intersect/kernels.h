// Kernels of a primitive of any kind. They are compiled once, in kernels.cpp, so every backend runs
// the same instructions and gets the same bits.
#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// The kernels that core/intersect/shapes/all_shapes.h describes, called for a primitive's shape.
Box3 primitive_bounds(const Geometry& geometry, std::uint32_t primitive);
double primitive_first_hit(const Geometry& geometry, std::uint32_t primitive,
                           const RayQuery& query);

/// Returns the box padded for the roundings of sums of coordinates, which may exceed the size of a
/// small shape far from the origin: by eight roundings of each axis's largest coordinate.
Box3 widened(const Box3& box);

/// Returns a box that contains every point that can be hit. Bounds that are a shape's own numbers
/// are exact and used as they are; bounds that are sums are widened.
Box3 whole_bounds(const Geometry& geometry, std::uint32_t primitive);

/// Returns whether a ray that hits a cut-out primitive does so in a hole. The kernel calls this.
bool meets_hole(const Geometry& geometry, std::uint32_t primitive, const RayQuery& query);

/// The same as primitive_first_hit() for callers that have the shape itself, which saves two cache
/// misses for the look-up by number. Of triangles only the corners are used. Cut-out triangles must
/// not be given.
template <class Shape>
double shape_first_hit(const Geometry& geometry, const Shape& shape, Sides sides,
                       const RayQuery& query);
extern template double shape_first_hit(const Geometry&, const Triangle&, Sides, const RayQuery&);
extern template double shape_first_hit(const Geometry&, const Sphere&, Sides, const RayQuery&);

SurfacePoint surface_at(const Geometry& geometry, const Ray& ray, const Hit& hit);

}  // namespace etalon
