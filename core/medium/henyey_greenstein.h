#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// The phase function of Henyey and Greenstein (1941). Directions are unit vectors along the
/// light's way, seen from the eye: one that goes straight on has the cosine 1.
class HenyeyGreenstein {
  public:
    /// `g`: mean cosine, between -1 and 1.
    explicit HenyeyGreenstein(float g) : g_(g) {}

    /// Density per steradian of directions at that cosine: the value of the phase function, and the
    /// density of sample().
    float value(double cosine) const;

    /// The direction for `uv` in [0, 1)^2 after `direction`.
    Vec3 sample(const Vec3& direction, const Vec2& uv) const;

  private:
    double cosine_at(double u) const;

    double g_;
};

}  // namespace etalon
