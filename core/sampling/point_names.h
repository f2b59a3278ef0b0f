#pragma once

#include <cstdint>
#include <vector>

#include "core/sampling/sobol.h"

namespace etalon {

/// Names of points that will be generated together, in SoA layout: the seed of each one's set and
/// its index there. Padded to a multiple of sobol_lanes.
class PointNames {
  public:
    void add(std::uint32_t seed, std::uint32_t index) {
        if (size_ == seeds_.size()) make_room(2 * size_ + sobol_lanes);
        seeds_[size_] = seed;
        indices_[size_] = index;
        ++size_;
    }
    void clear() { size_ = 0; }

    /// Sets the number of names; those that are new are arbitrary.
    void resize(std::size_t size) {
        size_ = size;
        if (padded_size() > seeds_.size()) make_room(2 * padded_size());
    }

    std::size_t size() const { return size_; }
    std::size_t padded_size() const {
        return (size_ + sobol_lanes - 1) / sobol_lanes * sobol_lanes;
    }
    const std::uint32_t* seeds() const { return seeds_.data(); }
    const std::uint32_t* indices() const { return indices_.data(); }
    std::uint32_t* seeds() { return seeds_.data(); }
    std::uint32_t* indices() { return indices_.data(); }

  private:
    void make_room(std::size_t size) {
        for (auto* row : {&seeds_, &indices_}) row->resize(size);
    }

    std::size_t size_ = 0;
    std::vector<std::uint32_t> seeds_, indices_;
};

}  // namespace etalon
