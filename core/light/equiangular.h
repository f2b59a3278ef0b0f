#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Samples points of a ray interval, uniformly in the angle under which a point light sees them
/// (Kulla & Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating
/// Media").
class Equiangular {
  public:
    /// The interval is from `begin` to `end`, which may be infinite; `direction` is of unit length.
    Equiangular(const Vec3& light, const Vec3& origin, const Vec3& direction, double begin,
                double end);

    /// Returns the distance along the ray, for u in [0, 1).
    double sample(double u) const;

    /// Returns the density of sample() per unit of length; 0 outside the interval.
    double density(double distance) const;

  private:
    double begin_, end_;
    double nearest_;  ///< distance of the point nearest to the light
    double gap_;      ///< distance from that point to the light
    double first_angle_, angle_;
};

}  // namespace etalon
