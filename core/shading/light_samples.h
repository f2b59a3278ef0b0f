#pragma once

#include "core/numerics/vec.h"
#include "core/scene/light.h"

namespace etalon {

/// A light replaced by count() point lights, each with its share of the colour.
class LightSamples {
  public:
    /// With samples_per_pixel 0 the image is deterministic: a quad light is a regular grid of its
    /// own number of points. Otherwise its points are distributed over the pixel's samples.
    LightSamples(const Light& light, int samples_per_pixel);

    int count() const { return count_; }
    const Color& color() const { return color_; }

    /// Returns whether the points are chosen by the pixel's samples.
    bool is_random() const { return is_random_; }

    /// Returns the position of point `k` < count(). Not for random points.
    Vec3 position(int k) const;

    /// Returns the position of the random point for uv in [0, 1)^2.
    Vec3 position(const Vec2& uv) const;

  private:
    const Light& light_;
    int count_ = 1;
    bool is_random_ = false;
    int columns_ = 1;  ///< columns of the regular grid
    Color color_;
};

}  // namespace etalon
