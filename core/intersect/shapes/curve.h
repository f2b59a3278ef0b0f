#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/curve_list.h"

namespace etalon {

// A curve is defined by its intersection, by pbrt-v3's rules (Pharr, Jakob & Humphreys 2016,
// section 3.7): the curve is seen along the ray and halved until the pieces are straight to a
// twentieth of the width. It is hit where the ray passes a piece within half the width, and t is
// that of the curve's point there. No answer is more exact than that of this code, which runs in
// double for every backend and for the oracle.

Box3 bounds(const Geometry& geometry, const StoredCurve& c);
double first_hit(const Geometry& geometry, const StoredCurve& c, Sides sides, const RayQuery& q);

/// Returns the point of the ray, up to the curve's own roundings. A ray that leaves it starts two
/// widths away, as in pbrt-v3, since the curve is nowhere as thick, seen from any direction. For a
/// ribbon these are whole widths too, since another ray may see it wider than the one that hit it.
SurfacePoint surface(const Geometry& geometry, const StoredCurve& c, const RayQuery& q, double t);

/// Returns pbrt's parametrization: u along the whole curve, v across, from 0 to 1 as the ray saw
/// it.
Parametrization parametrization(const Geometry& geometry, const StoredCurve& c,
                                const SurfacePoint& p);

}  // namespace etalon
