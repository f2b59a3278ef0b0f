// Well distributed sample points that depend on nothing but their names: pixel, sample, dimension
// and seed. No state, so any order, tiling or machine gives the same point.
#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// A 32-bit mix of two words; the basis of all names of dimensions.
std::uint32_t hash(std::uint32_t a, std::uint32_t b);

/// Point `index` of the two-dimensional Sobol' sequence, Owen-scrambled, its order shuffled by a
/// scramble of the index (Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)). Every
/// seed gives an independent randomisation; in [0, 1)^2.
Vec2 scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// One sample of one pixel: a source of points, one for each dimension asked.
class SampleSource {
  public:
    /// Sample number `index` of the pixel (x, y).
    SampleSource(int x, int y, std::uint32_t seed, std::uint32_t index)
        : pixel_(hash(hash(seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y))),
          index_(index) {}

    Vec2 point(std::uint32_t dimension) const { return part(dimension, 0, 1); }

    /// Where a dimension wants several points of each sample: number `k` of `parts`. Over all
    /// samples of the pixel they make one well distributed set.
    Vec2 part(std::uint32_t dimension, std::uint32_t k, std::uint32_t parts) const {
        return scrambled_sobol(index_ * parts + k, hash(pixel_, dimension));
    }

  private:
    std::uint32_t pixel_, index_;
};

}  // namespace etalon
