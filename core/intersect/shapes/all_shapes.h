// All kernels. Each shape has four overloads; no other code decides how a shape is hit:
//
//   Box3 bounds(geometry, shape)
//       Contains every point that can be hit. Infinite for an unbounded shape, empty for a
//       degenerate one (zero extent, not finite), which is then never hit.
//   double first_hit(geometry, shape, sides, query)
//       The smallest finite t > query.ray.tmin at which a visible side of the shape is hit, or
//       no_hit. The ray must be finite and its direction not zero, which Intersector ensures.
//       The point at that t is never outside the shape's bounds by more than a few roundings.
//   SurfacePoint surface(geometry, shape, query, t)
//       The point at a t that first_hit returned (or, from another source, close to it).
//   Parametrization parametrization(geometry, shape, point)
//       The (u, v) and the derivatives at a point that surface() returned: finite, and the
//       derivatives tangent. Where they do not span the tangent plane, as at a pole, the caller
//       replaces them.
//
// A solid shape whose faces meet at edges has a fifth, for points of instances:
//
//   bool move_off_edges(shape, distance, point)
//       Moves a point of a face along it, so that no point nearer than `distance`, for each axis,
//       is beyond another face. Returns whether it was moved.
#pragma once

#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/closed_cylinder.h"
#include "core/intersect/shapes/cone.h"
#include "core/intersect/shapes/curve.h"
#include "core/intersect/shapes/ellipsoid.h"
#include "core/intersect/shapes/plane.h"
#include "core/intersect/shapes/polygon.h"
#include "core/intersect/shapes/quadric.h"
#include "core/intersect/shapes/revolved.h"
#include "core/intersect/shapes/ring.h"
#include "core/intersect/shapes/sphere.h"
#include "core/intersect/shapes/triangle.h"
