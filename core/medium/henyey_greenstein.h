#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// The phase function of Henyey and Greenstein (1941). Directions are unit vectors along the path
/// from the eye: one that goes straight on has the cosine 1.
class HenyeyGreenstein {
  public:
    /// `g` is the mean cosine, between -1 and 1.
    explicit HenyeyGreenstein(float g) : g_(g) {}

    /// Returns the phase function for that cosine, which is also the density of sample() per
    /// steradian.
    float value(double cosine) const;

    /// Samples the direction after `direction`, with `uv` in [0, 1)^2.
    Vec3 sample(const Vec3& direction, const Vec2& uv) const;

  private:
    double cosine_at(double u) const;

    double g_;
};

}  // namespace etalon
