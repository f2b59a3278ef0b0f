// Affine maps for the transforms of scene files.
#pragma once

#include "core/numerics/affine.h"

namespace etalon {

Affine translation(const Vec3& offset);
Affine scaling(const Vec3& factors);

/// Returns the right-handed rotation about an axis of any length but zero: a positive angle rotates
/// x to y about z. Quarter turns about a coordinate axis are exact.
Affine rotation(double degrees, const Vec3& axis);

/// Returns a rotation that takes z to the direction of `axis`, followed by a translation to
/// `origin`. The axis may be of any length but zero.
Affine about_axis(const Vec3& origin, const Vec3& axis);

/// Returns whether the map is singular, as far as can be told: its determinant, a sum of six
/// products, is no more than the roundings of the map's twelve numbers may have made of zero. A
/// scale by which a map was composed, however uneven, does not make it singular.
bool is_singular(const Affine& map);

/// Returns whether the map changes handedness. It must not be singular.
bool mirrors(const Affine& map);

/// Transforms normals by a map: by the transpose of its inverse up to a positive factor, so that
/// they stay perpendicular and on their side. The map must not be singular.
class NormalMap {
  public:
    explicit NormalMap(const Affine& map);

    Vec3 operator()(const Vec3& normal) const {
        return normal.x * x_ + normal.y * y_ + normal.z * z_;
    }

  private:
    Vec3 x_, y_, z_;
};

}  // namespace etalon
