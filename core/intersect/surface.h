#pragma once

#include "core/numerics/rounding.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Where a ray met a surface, refined onto the surface.
struct SurfacePoint {
    Vec3 position;
    /// Per axis, how far the position may be from the true surface as the kernel sees it: a ray
    /// that starts further out than this does not meet the surface it left.
    Vec3 error;
    Vec3 normal;          ///< geometric, unit, as the shape defines it (outward, or by winding)
    Vec3 shading_normal;  ///< unit; interpolated where the shape has corner normals
};

/// The bound used by the kernels: both the position's rounding and the kernel's own evaluation are
/// a few dozen roundings of quantities no larger than these; 64 leaves room for all of them.
inline Vec3 position_error(const Vec3& magnitude, double extent) {
    return 64 * unit_roundoff * (magnitude + Vec3(extent));
}

/// Origin for a ray that leaves `p` towards `direction`: moved off the surface along the geometric
/// normal, to the direction's side, by the error bound projected on the normal, and each coordinate
/// then rounded away (Pharr, Jakob & Humphreys 2016, section 3.9.5).
inline Vec3 spawn_origin(const SurfacePoint& p, const Vec3& direction) {
    const double distance = abs(p.normal).dot(p.error);
    const double side = p.normal.dot(direction) < 0 ? -1.0 : 1.0;
    const Vec3 offset = side * distance * p.normal;
    Vec3 origin = p.position + offset;
    for (int k = 0; k < 3; ++k) {
        if (offset[k] != 0)
            origin[k] = std::nextafter(origin[k], std::copysign(infinity, offset[k]));
    }
    return origin;
}

}  // namespace etalon
