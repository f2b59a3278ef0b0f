#pragma once

#include <algorithm>

#include "core/parallel/parallel.h"

namespace etalon {

/// [0, count) divided into pieces of one size (the last may be shorter). The pieces are the same
/// for any number of threads, so results found piece by piece do not depend on it either.
class Chunks {
  public:
    Chunks(std::size_t count, std::size_t size) : count_(count), size_(size) {}

    std::size_t number() const { return (count_ + size_ - 1) / size_; }
    std::size_t begin(std::size_t chunk) const { return chunk * size_; }
    std::size_t end(std::size_t chunk) const { return std::min(count_, begin(chunk) + size_); }

    /// Calls body(chunk, begin, end) for each, possibly in parallel.
    template <class Body>
    void parallel_for_each(const Body& body) const {
        parallel_for(number(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) body(i, begin(i), end(i));
        });
    }

  private:
    std::size_t count_, size_;
};

}  // namespace etalon
