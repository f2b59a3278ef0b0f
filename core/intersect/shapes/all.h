// Every kernel. For each shape three overloads, and nothing else knows how a shape is hit:
//
//   Box3 bounds(scene, shape)
//       Contains every point that can be hit. Infinite for an unbounded shape, empty for a
//       degenerate one (zero extent, not finite), which is then never hit.
//   double first_hit(scene, shape, sides, query)
//       The smallest finite t > query.ray.tmin at which a visible side of the shape is met, or
//       no_hit. The ray is finite and its direction not zero: Intersector sees to that.
//       A point so found is never outside the shape's bounds by more than a few roundings.
//   SurfacePoint surface(scene, shape, query, t)
//       The point at a t that first_hit returned (or, from another source, close to it).
#pragma once

#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/closed_cylinder.h"
#include "core/intersect/shapes/cone.h"
#include "core/intersect/shapes/ellipsoid.h"
#include "core/intersect/shapes/plane.h"
#include "core/intersect/shapes/polygon.h"
#include "core/intersect/shapes/sphere.h"
#include "core/intersect/shapes/triangle.h"
