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
    std::vector<Vec3> points, normals;   ///< as many; normals of any length, 0 where there is none
    std::vector<std::uint32_t> corners;  ///< three for each triangle
};

/// The limit surface of Loop's scheme (Loop 1987) over a control mesh, seen at the vertices of
/// `levels` refinements: limit positions and normals, with boundaries as Hoppe et al. 1994 have
/// them. Normals are on the side from which triangles run clockwise, as pbrt-v3's are, and weights
/// and order of the result are pbrt-v3's too. `corners`: three vertices a triangle. Points that no
/// triangle names stay where they are, without a normal. An error where a corner is no point, a
/// triangle names one twice, an edge belongs to more than two triangles or they do not turn alike,
/// or where the result would be too large.
Result<SmoothMesh> loop_subdivision(std::span<const Vec3> points,
                                    std::span<const std::uint32_t> corners, int levels);

}  // namespace etalon
