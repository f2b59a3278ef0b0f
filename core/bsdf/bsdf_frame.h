#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// The local frame in which lobes scatter: z is the shading normal. The geometric normal decides
/// whether light is reflected or transmitted.
struct BsdfFrame {
    /// Makes a frame with an arbitrary tangent.
    BsdfFrame(const Vec3& geometric, const Vec3& shading) : ng(geometric), ns(shading) {
        orthonormal_basis(ns, x, y);
    }

    /// Makes a frame from unit normals, geometric and shading, not turned to the eye; the side to
    /// which they point is above. `tangent` becomes x once made orthogonal to the shading normal.
    /// If it is zero or parallel to that normal, x is arbitrary.
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
        // A step of Newton's method towards unit length, up to the roundings of floats.
        return sum * (1.5 - 0.5 * sum.dot(sum));
    }

    Vec3 ng, ns, x, y;
};

}  // namespace etalon
