#pragma once

#include <cstdint>
#include <vector>

#include "core/sampling/sobol.h"

namespace etalon {

/// Names of points that will be generated together, in SoA layout: the seed of each one's set and
/// its index there. Padded to a multiple of SobolBatch::lanes.
class PointNames {
  public:
    void add(std::uint32_t seed, std::uint32_t index) {
        if (size_ == seeds_.size()) {
            for (auto* row : {&seeds_, &indices_}) row->resize(2 * size_ + SobolBatch::lanes);
        }
        seeds_[size_] = seed;
        indices_[size_] = index;
        ++size_;
    }
    void clear() { size_ = 0; }

    std::size_t size() const { return size_; }
    std::size_t padded_size() const {
        return (size_ + SobolBatch::lanes - 1) / SobolBatch::lanes * SobolBatch::lanes;
    }
    const std::uint32_t* seeds() const { return seeds_.data(); }
    const std::uint32_t* indices() const { return indices_.data(); }

  private:
    std::size_t size_ = 0;
    std::vector<std::uint32_t> seeds_, indices_;
};

}  // namespace etalon
