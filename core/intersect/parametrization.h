#pragma once

#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Surface coordinates (u, v) of a point and the derivatives of the point by them (world space).
struct Parametrization {
    Vec2 uv;
    Vec3 dpdu, dpdv;
};

/// Returns the surface coordinates of a point that surface_at() returned, in [0, 1] except on
/// planes and polygons. The derivatives span the tangent plane. Where the shape's own do not, as at
/// poles, tips and centres, they are two orthogonal unit vectors.
Parametrization parametrization_at(const Geometry& geometry, const SurfacePoint& point);

}  // namespace etalon
