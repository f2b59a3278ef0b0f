// Affine maps as scene files ask for them.
#pragma once

#include "core/numerics/affine.h"

namespace etalon {

Affine translation(const Vec3& offset);
Affine scaling(const Vec3& factors);

/// Rotation about an axis of any length but zero, right-handed: a positive angle turns x to y about
/// z. Quarter turns about an axis of the space are exact.
Affine rotation(double degrees, const Vec3& axis);

/// A turn that takes z to where `axis` points, then a move to `origin`. The axis may be of any
/// length but zero.
Affine about_axis(const Vec3& origin, const Vec3& axis);

/// Returns whether the map leaves no volume, as far as can be told: its determinant, a sum of six
/// products, is no more than the roundings of the map's twelve numbers may have made of zero. No
/// scale by which a map was composed, however uneven, makes it singular.
bool is_singular(const Affine& map);

/// Returns whether the map turns right hands into left ones. It must not be singular.
bool mirrors(const Affine& map);

/// How a map carries normals: by the transpose of its inverse but for a positive factor, so that
/// they stay perpendicular, and on their side. The map must not be singular.
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
