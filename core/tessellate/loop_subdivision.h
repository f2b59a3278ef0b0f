#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Triangles with normals at their corners.
struct SmoothMesh {
    std::vector<Vec3> points, normals;   ///< one normal for each point, of any length; 0 for none
    std::vector<std::uint32_t> corners;  ///< three for each triangle
};

/// Returns the limit surface of Loop's scheme (Loop 1987) over a control mesh, at the vertices of
/// `levels` refinements: limit positions and normals, with the boundary rules of Hoppe et al. 1994.
/// Normals are on the side from which triangles run clockwise, like pbrt-v3's, and weights and
/// order of the result are pbrt-v3's too. `corners` has three vertices for each triangle. Points
/// that no triangle uses stay where they are, without a normal. Returns an error if a corner is not
/// a point, a triangle names one twice, an edge belongs to more than two triangles or these are not
/// consistently oriented, or if the result would be too large.
Result<SmoothMesh> loop_subdivision(std::span<const Vec3> points,
                                    std::span<const std::uint32_t> corners, int levels);

}  // namespace etalon
