#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/shapes/revolved_exact.h"
#include "core/intersect/shapes/revolved_fast.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

Box3 bounds(const Geometry&, const Revolved& s);

/// Returns the first visible t. Hit or miss is right for every ray, and t good to t_tolerance.
inline double first_hit(const Geometry&, const Revolved& s, Sides sides, const RayQuery& q) {
    const double t = RevolvedFastPath(s, q).first_hit(sides);
    return t == uncertain ? exact_first_hit(s, sides, q.ray) : t;
}

SurfacePoint surface(const Geometry&, const Revolved& s, const RayQuery& q, double t);

/// Returns the image of the parametrization of pbrt-v3's sphere, disk, cylinder, cone, paraboloid
/// or hyperboloid.
Parametrization parametrization(const Geometry&, const Revolved& s, const SurfacePoint& p);

/// Returns the gradient of the form that vanishes on the surface, in local coordinates; the axis at
/// a tip, where the gradient is zero.
Vec3 gradient(const Profile& profile, const Vec3& local);

/// Returns the surface coordinates of a point and their derivatives, in local coordinates.
Parametrization revolved_chart(const Revolved& s, const Vec3& local);

}  // namespace etalon
