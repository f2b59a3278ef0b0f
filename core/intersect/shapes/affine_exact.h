// Ellipsoids and closed cylinders in exact arithmetic: slow, and right for every finite ray.
#pragma once

#include "core/intersect/shapes/roots.h"

namespace etalon {

/// Whether the line of the ray meets the solid is exact; where it does, good to a few ulp. Nothing
/// for a degenerate shape, and for a ray that is not finite.
[[gnu::cold]] Passage exact_passage(const Ellipsoid& e, const Ray& ray);
[[gnu::cold]] Passage exact_passage(const ClosedCylinder& c, const Ray& ray);

}  // namespace etalon
