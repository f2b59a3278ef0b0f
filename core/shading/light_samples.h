#pragma once

#include <cstdint>

#include "core/sampling/sample_source.h"
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

    /// Position of point `k` < count(); `dimension` names the choice within the sample.
    Vec3 position(int k, const SampleSource& sample, std::uint32_t dimension) const;

  private:
    const Light& light_;
    int count_ = 1;
    int columns_ = 0;  ///< columns of the regular grid; 0: points are taken from the sample
    Color color_;
};

}  // namespace etalon
