// Features of a shape where kernels are most likely to be wrong: silhouettes, rims, corners, edges.
// The compiler reports missing ones of a new shape.
#pragma once

#include <functional>
#include <vector>

#include "core/numerics/random.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns a point to aim at, seen from `from`.
using Target = std::function<Vec3(const Vec3& from, Random& random)>;

/// Returns the targets of an item. Silhouettes, rims and apexes are missed by down to 10^finest of
/// the shape's size, corners and edges not at all, since kernels guarantee the side on which a ray
/// passes a flat face. For an instance these are the targets of its object's primitives, which must
/// exist; for a moving one they are where rays of that `time` see it. The geometry must outlive the
/// targets.
std::vector<Target> targets_of(const Geometry& geometry, std::uint32_t item, double finest,
                               ShutterTime time = 0);

/// Returns a point with `fixed` of its coordinates on faces: 0 inside, 1 a face, 2 an edge, 3 a
/// corner.
Vec3 on_faces(const Box& box, int fixed, Random& random);

}  // namespace etalon
