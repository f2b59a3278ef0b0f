// Surfaces without a hole.
#pragma once

#include "core/scene/scene.h"
#include "core/test_rays/outline.h"

namespace etalon::hard {

enum class Faces { triangles, mixed };  ///< mixed: quads and triangles by turns

/// A latitude-longitude sphere of 100 rings of 200 faces, stretched to an ellipsoid; corners
/// rounded to float. Its poles are shared by 200 triangles each.
Scene uv_sphere(const Vec3& centre, const Vec3& radius, Faces faces);

/// Heights between 0 and 1 above a square of 255 x 255 unit cells from `corner` on, two triangles
/// each: no facet is steeper than sqrt(2). Corners rounded to float.
inline constexpr std::uint32_t terrain_cells = 255;
Scene terrain(const Vec3& corner);

/// The first of the two triangles on the cell of the terrain.
inline std::uint32_t terrain_face(std::uint32_t column, std::uint32_t row) {
    return 2 * (row * terrain_cells + column);
}

}  // namespace etalon::hard
