#pragma once

#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/quadric_exact.h"
#include "core/intersect/shapes/quadric_fast.h"
#include "core/intersect/surface.h"

namespace etalon {

inline Box3 bounds(const Geometry&, const Quadric& s) {
    return is_degenerate(s) ? Box3() : s.clip;
}

/// Returns the first visible t. Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Geometry&, const Quadric& s, Sides sides, const RayQuery& q) {
    const double t = QuadricFastPath(s, q).first_hit(sides);
    return t == uncertain ? exact_first_hit(s, sides, q.ray) : t;
}

SurfacePoint surface(const Geometry&, const Quadric& s, const RayQuery& q, double t);

/// Projects onto the faces of the clipping box: see box_chart(). The coordinates jump where the
/// normal turns to another face. dpdu x dpdv points where the normal does.
inline Parametrization parametrization(const Geometry&, const Quadric& s, const SurfacePoint& p) {
    return box_chart(s.clip, p);
}

}  // namespace etalon
