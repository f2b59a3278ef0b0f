// Single triangles and polygons, aimed at.
#pragma once

#include "bench/hard_cases/rows.h"
#include "core/numerics/vec.h"

namespace etalon::hard {

using Corners = std::vector<Vec3>;

/// Every coordinate rounded to float.
Corners rounded(Corners corners);

Corners moved(Corners corners, const Vec3& by);

/// A star of so many points, in an odd plane; the inner corners are at `inner` of the outer ones.
Corners star(int points, double inner);

/// One triangle, or one polygon, and other rays.
CaseSetup only_face(const Corners& corners, double size, MakeRay ray);

/// Rays to corners, edges, their middles and the fan from the first corner, a quarter each, from a
/// tenth of the size to 1000 sizes away. Many rays go exactly through their target; half of them
/// pass it within a rounding of the direction.
CaseSetup aimed_at_face(const Corners& corners, double size);

/// Rays from anywhere in the face's plane to a corner, an edge or a middle of it, as rounded.
CaseSetup along_face(const Corners& corners, double size);

}  // namespace etalon::hard
