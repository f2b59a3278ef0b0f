// A surface of revolution and a ray in exact arithmetic: slow, and right for every finite ray.
#pragma once

#include "core/intersect/shapes/roots.h"

namespace etalon {

/// Returns the first visible t; no_hit for a degenerate surface, and for a ray that is not finite.
/// Hit and miss are exact, and t is good to a few ulp.
[[gnu::cold]] double exact_first_hit(const Revolved& s, Sides sides, const Ray& ray);

}  // namespace etalon
