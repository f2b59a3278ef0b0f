#pragma once

#include <span>

#include "core/numerics/vec_columns.h"
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

    /// Writes the positions of the random points for `uvs` in [0, 1)^2, which is padded.
    void find_positions(std::span<const Vec2> uvs, Vec3Buffer& positions) const;

  private:
    const Light& light_;
    int count_ = 1;
    bool is_random_ = false;
    int columns_ = 1;  ///< columns of the regular grid
    Color color_;
};

}  // namespace etalon
