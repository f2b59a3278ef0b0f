// A primitive's kernels, whatever its kind. They are compiled once, in kernels.cpp, so every
// backend runs the same instructions and gets the same bits.
#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// See core/intersect/shapes/all_shapes.h for what these promise.
Box3 primitive_bounds(const Geometry& geometry, std::uint32_t primitive);
double primitive_first_hit(const Geometry& geometry, std::uint32_t primitive,
                           const RayQuery& query);

/// The box with room for the roundings of sums of coordinates, which far from the origin are more
/// than a small shape's size: up to eight of those of each axis's largest coordinate.
Box3 widened(const Box3& box);

/// A box of which no point that can be hit is outside. The numbers of some shapes are its own;
/// those of others are sums, and their box is widened.
Box3 whole_bounds(const Geometry& geometry, std::uint32_t primitive);

/// Whether a ray that meets a primitive which is cut out does so in a hole. The kernel asks this.
bool meets_hole(const Geometry& geometry, std::uint32_t primitive, const RayQuery& query);

/// The same as primitive_first_hit() for whoever has the shape at hand: a primitive's number leads
/// to it over two cache misses. Triangles only need their corners; those that are cut out are not
/// for it.
template <class Shape>
double shape_first_hit(const Geometry& geometry, const Shape& shape, Sides sides,
                       const RayQuery& query);
extern template double shape_first_hit(const Geometry&, const Triangle&, Sides, const RayQuery&);
extern template double shape_first_hit(const Geometry&, const Sphere&, Sides, const RayQuery&);

SurfacePoint surface_at(const Geometry& geometry, const Ray& ray, const Hit& hit);

}  // namespace etalon
