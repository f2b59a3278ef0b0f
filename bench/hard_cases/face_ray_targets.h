// Rays aimed at single triangles and polygons.
#pragma once

#include "bench/hard_cases/rows.h"
#include "core/numerics/vec.h"

namespace etalon::hard {

using Corners = std::vector<Vec3>;

/// Rounds every coordinate to float.
Corners rounded(Corners corners);

Corners moved(Corners corners, const Vec3& by);

/// Returns a star with so many points, in a plane of no special direction; the inner corners are at
/// `inner` of the outer ones.
Corners star(int points, double inner);

/// Returns a scene of one triangle or polygon, with given rays.
CaseSetup only_face(const Corners& corners, double size, MakeRay ray);

/// Returns rays to corners, edges, midpoints and the fan from the first corner, a quarter each,
/// from a tenth of the size to 1000 sizes away. Many rays pass exactly through their target; half
/// of them pass it within a rounding of the direction.
CaseSetup aimed_at_face(const Corners& corners, double size);

/// Returns rays from anywhere in the face's plane to a corner, an edge or a midpoint of it, as
/// rounded.
CaseSetup along_face(const Corners& corners, double size);

}  // namespace etalon::hard
