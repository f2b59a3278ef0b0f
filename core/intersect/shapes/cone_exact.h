// A cone and a ray in exact arithmetic: slow, and right for every finite ray.
#pragma once

#include "core/intersect/shapes/roots.h"

namespace etalon {

inline bool is_degenerate(const Cone& c) {
    const double width = c.base_radius + c.top_radius;
    return !is_finite(c.base) || !is_finite(c.top) || c.base == c.top || c.base_radius < 0 ||
           c.top_radius < 0 || !(width > 0 && width < infinity);
}

/// Returns the points where the line of the ray crosses the lateral surface: none for a degenerate
/// cone and for a ray that is not finite. Whether there is an entry and an exit is exact; their t
/// is good to a few ulp.
[[gnu::cold]] Passage exact_passage(const Cone& cone, const Ray& ray);

}  // namespace etalon
