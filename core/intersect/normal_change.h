#pragma once

#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns the derivative of the unit shading normal at a point that surface_at() returned, as the
/// point moves along a vector of the tangent plane. Zero for flat shapes, and for those that only
/// scenes without bump maps have.
Vec3 normal_change(const Geometry& geometry, const SurfacePoint& point, const Vec3& along);

}  // namespace etalon
