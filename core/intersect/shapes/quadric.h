#pragma once

#include "core/intersect/shapes/quadric_exact.h"
#include "core/intersect/shapes/quadric_sieve.h"
#include "core/intersect/surface.h"

namespace etalon {

inline Box3 bounds(const Geometry&, const Quadric& s) {
    return is_degenerate(s) ? Box3() : s.clip;
}

/// Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Geometry&, const Quadric& s, Sides sides, const RayQuery& q) {
    const double t = QuadricSieve(s, q).first_hit(sides);
    return t == in_doubt ? exact_first_hit(s, sides, q.ray) : t;
}

SurfacePoint surface(const Geometry&, const Quadric& s, const RayQuery& q, double t);

}  // namespace etalon
