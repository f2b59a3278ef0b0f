#pragma once

#include "core/numerics/random.h"

namespace etalon {

/// Independent numbers in [0, 1) for a decision that needs any number of them, identified by a seed
/// and the number of the sample.
class RandomSequence {
  public:
    RandomSequence(std::uint32_t seed, std::uint32_t index)
        : numbers_(static_cast<std::uint64_t>(seed) << 32 | index) {}

    double next() { return numbers_.uniform(); }

  private:
    Random numbers_;
};

}  // namespace etalon
