#pragma once

#include "core/numerics/vec.h"
#include "core/scene/light.h"

namespace etalon {

/// A light seen as so many point lights, each with its share of the colour.
class LightSamples {
  public:
    /// samples_per_pixel 0 asks for a deterministic image: a quad light is a regular grid of its
    /// own number of points. Otherwise its number is spread over the pixel's samples.
    LightSamples(const Light& light, int samples_per_pixel);

    int count() const { return count_; }
    const Color& color() const { return color_; }

    /// Whether the points are taken from the pixel's samples.
    bool is_random() const { return is_random_; }

    /// Position of point `k` < count(), unless random.
    Vec3 position(int k) const;

    /// Position of the point for uv in [0, 1)^2, if random.
    Vec3 position(const Vec2& uv) const;

  private:
    const Light& light_;
    int count_ = 1;
    bool is_random_ = false;
    int columns_ = 1;  ///< columns of the regular grid
    Color color_;
};

}  // namespace etalon
