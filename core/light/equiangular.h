#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Points of a part of a ray, evenly distributed by the angle under which a point light sees them
/// (Kulla & Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating
/// Media").
class Equiangular {
  public:
    /// The part from `begin` to `end`, which may be infinite; `direction` is of unit length.
    Equiangular(const Vec3& light, const Vec3& origin, const Vec3& direction, double begin,
                double end);

    /// Distance along the ray, for u in [0, 1).
    double sample(double u) const;

    /// Density of sample() per unit of length; 0 outside the part.
    double density(double distance) const;

  private:
    double begin_, end_;
    double nearest_;  ///< distance of the point next to the light
    double gap_;      ///< from there to the light
    double first_angle_, angle_;
};

}  // namespace etalon
