// The sample points of an image, each named by its pixel, sample, dimension and seed.
#pragma once

#include "core/sampling/sobol.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// One sample of one pixel: a source of points, one for each dimension asked.
class SampleSource {
  public:
    /// Sample number `index` of the pixel (x, y).
    SampleSource(int x, int y, std::uint32_t seed, std::uint32_t index,
                 Sampler sampler = Sampler::sobol)
        : pixel_(hash(hash(seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y))),
          index_(index),
          points_(sampler == Sampler::sobol ? scrambled_sobol : uniform_random) {}

    Vec2 point(std::uint32_t dimension) const { return stratified(dimension, 0, 1); }

    /// Point number `k` of `parts`, where a dimension wants several points of each sample. Over all
    /// samples of the pixel they make one well distributed set.
    Vec2 stratified(std::uint32_t dimension, std::uint32_t k, std::uint32_t parts) const {
        return points_(index_ * parts + k, hash(pixel_, dimension));
    }

  private:
    std::uint32_t pixel_, index_;
    Vec2 (*points_)(std::uint32_t index, std::uint32_t seed);
};

}  // namespace etalon
