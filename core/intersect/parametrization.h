#pragma once

#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Surface coordinates of a point, and how the point moves with them (world space).
struct Parametrization {
    Vec2 uv;
    Vec3 dpdu, dpdv;
};

/// Surface coordinates of a point that surface_at() returned, in [0, 1] except on planes and
/// polygons. The derivatives span the tangent plane: where the shape's own do not, as at poles,
/// tips and centres, they are two unit vectors at right angles.
Parametrization parametrization_at(const Geometry& geometry, const SurfacePoint& point);

}  // namespace etalon
