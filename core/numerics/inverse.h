#pragma once

#include "core/numerics/affine.h"

namespace etalon {

/// What undoes the linear part of an affine map: the inverse matrix by rows. From exact minors and
/// an exact determinant, so that every number is good to three roundings however ill-conditioned
/// the map is.
struct LinearInverse {
    explicit LinearInverse(const Affine& map);

    Vec3 vector(const Vec3& v) const { return {x.dot(v), y.dot(v), z.dot(v)}; }

    /// Of a normal, which is no vector but a row: its length is not kept.
    Vec3 normal(const Vec3& local) const { return local.x * x + local.y * y + local.z * z; }

    Vec3 x{0}, y{0}, z{0};
    Vec3 lengths{0};      ///< of the rows, rounded up
    bool exists = false;  ///< false for a map that is singular, or not finite
};

}  // namespace etalon
