// Closed surfaces.
#pragma once

#include "core/scene/scene.h"
#include "core/test_rays/outline.h"

namespace etalon::hard {

enum class Faces { triangles, mixed };  ///< mixed: alternating quads and triangles

/// Returns a latitude-longitude sphere of 100 rings of 200 faces, stretched to an ellipsoid, with
/// corners rounded to float. Each pole is shared by 200 triangles.
Scene uv_sphere(const Vec3& centre, const Vec3& radius, Faces faces);

/// Returns a height field between 0 and 1 above a square of 255 x 255 unit cells from `corner` on,
/// with two triangles each: no facet is steeper than sqrt(2). Corners are rounded to float.
inline constexpr std::uint32_t terrain_cells = 255;
Scene terrain(const Vec3& corner);

/// Returns the first of the two triangles of a cell of the terrain.
inline std::uint32_t terrain_face(std::uint32_t column, std::uint32_t row) {
    return 2 * (row * terrain_cells + column);
}

}  // namespace etalon::hard
