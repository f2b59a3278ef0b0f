// What there is to aim at on a shape, where kernels are most likely to be wrong: silhouettes, rims,
// corners, edges. The compiler asks for those of a new shape.
#pragma once

#include <functional>
#include <vector>

#include "core/numerics/random.h"
#include "core/scene/geometry.h"

namespace etalon {

/// A point to aim at, seen from `from`.
using Target = std::function<Vec3(const Vec3& from, Random& random)>;

/// Silhouettes, rims and apexes are missed by down to 10^finest of the shape's size, corners and
/// edges by nothing at all: of flat faces kernels promise to know on which side they are passed. Of
/// an instance the targets are those of its object's primitives, which must be there; of one
/// that moves they are where rays of that `time` see it. The geometry must outlive the targets.
std::vector<Target> targets_of(const Geometry& geometry, std::uint32_t item, double finest,
                               ShutterTime time = 0);

/// A point with `fixed` of its coordinates on faces: 0 inside, 1 a face, 2 an edge, 3 a corner.
Vec3 on_faces(const Box& box, int fixed, Random& random);

}  // namespace etalon
