// Ellipsoids and closed cylinders in exact arithmetic: slow, and right for every finite ray.
#pragma once

#include "core/intersect/shapes/roots.h"

namespace etalon {

/// Returns where the line of the ray enters and leaves the solid: nothing for a degenerate shape
/// and for a ray that is not finite. Hit or miss is exact; the points are good to a few ulp.
[[gnu::cold]] Passage exact_passage(const Ellipsoid& e, const Ray& ray);
[[gnu::cold]] Passage exact_passage(const ClosedCylinder& c, const Ray& ray);

}  // namespace etalon
