#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// The frame of a surface's point in which lobes scatter: z is the shading normal. Whether light is
/// reflected or transmitted is decided by the geometric normal.
struct BsdfFrame {
    /// With an arbitrary tangent.
    BsdfFrame(const Vec3& geometric, const Vec3& shading) : ng(geometric), ns(shading) {
        orthonormal_basis(ns, x, y);
    }

    /// Unit normals, geometric and shading, not turned to the eye; what lies on their side is
    /// above. `tangent`: x once made orthogonal to the shading normal; any of a length of 0 or
    /// along that normal stands for an arbitrary one.
    BsdfFrame(const Vec3& geometric, const Vec3& shading, const Vec3& tangent)
        : ng(geometric), ns(shading) {
        const Vec3 across = tangent - ns.dot(tangent) * ns;
        const double length2 = across.dot(across);
        if (length2 > 1e-12 * tangent.dot(tangent)) {
            x = across / std::sqrt(length2);
            y = ns.cross(x);
        } else {
            orthonormal_basis(ns, x, y);
        }
    }

    Vec3 to_local(const Vec3& w) const { return {w.dot(x), w.dot(y), w.dot(ns)}; }

    Vec3 to_world(const Vec3& w) const {
        const Vec3 sum = w.x * x + w.y * y + w.z * ns;
        // A step of Newton's method towards unit length, off by the roundings of floats.
        return sum * (1.5 - 0.5 * sum.dot(sum));
    }

    Vec3 ng, ns, x, y;
};

}  // namespace etalon
