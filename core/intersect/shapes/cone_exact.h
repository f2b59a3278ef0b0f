// A cone and a ray in exact arithmetic: slow, and right for every finite ray.
#pragma once

#include "core/intersect/ray.h"
#include "core/scene/scene.h"

namespace etalon {

/// Where a line goes into the solid cone, and where it comes out, through the lateral surface; NaN
/// where it does not.
struct ConeCrossing {
    double entry = no_hit, exit = no_hit;
};

inline bool is_degenerate(const Cone& c) {
    const double width = c.base_radius + c.top_radius;
    return !is_finite(c.base) || !is_finite(c.top) || c.base == c.top || c.base_radius < 0 ||
           c.top_radius < 0 || !(width > 0 && width < infinity);
}

/// Whether there is an entry and an exit is exact; where they are, good to a few ulp. None for a
/// degenerate cone, and for a ray that is not finite.
[[gnu::cold]] ConeCrossing exact_crossing(const Cone& cone, const Ray& ray);

}  // namespace etalon
