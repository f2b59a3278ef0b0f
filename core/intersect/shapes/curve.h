#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/curve_list.h"

namespace etalon {

// What a curve is, is defined by the way it is met, by pbrt-v3's rules (Pharr, Jakob & Humphreys
// 2016, section 3.7): the curve is seen along the ray, halved until the pieces are straight to a
// twentieth of the width, and met where the ray passes a piece within half the width. The t is that
// of the curve's point there. There is no more exact answer than that of this code, which runs in
// double for every backend and for the oracle.

Box3 bounds(const Geometry& geometry, const StoredCurve& c);
double first_hit(const Geometry& geometry, const StoredCurve& c, Sides sides, const RayQuery& q);

/// The point of the ray, up to the curve's own roundings. A ray that leaves it starts two widths
/// away, as in pbrt-v3: the curve is nowhere as thick, whatever way it is seen. They are the whole
/// widths of a ribbon too, which another ray may see broader than the one that met it.
SurfacePoint surface(const Geometry& geometry, const StoredCurve& c, const RayQuery& q, double t);

/// Parametrization of pbrt: u along the whole curve, v across, from 0 to 1 as the ray saw it.
Parametrization parametrization(const Geometry& geometry, const StoredCurve& c,
                                const SurfacePoint& p);

}  // namespace etalon
