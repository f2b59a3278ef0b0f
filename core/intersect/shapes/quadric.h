#pragma once

#include "core/intersect/shapes/quadric_exact.h"
#include "core/intersect/surface.h"

namespace etalon {

inline Box3 bounds(const Scene&, const Quadric& s) {
    return is_degenerate(s) ? Box3() : s.clip;
}

/// Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Scene&, const Quadric& s, Sides sides, const RayQuery& q) {
    return exact_first_hit(s, sides, q.ray);
}

SurfacePoint surface(const Scene&, const Quadric& s, const RayQuery& q, double t);

}  // namespace etalon
