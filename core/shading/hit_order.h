#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/intersect/ray.h"

namespace etalon {

/// Numbers of some rays: from `first` to before `last` in an order.
struct HitRun {
    std::uint32_t first, last;
    std::uint32_t primitive;
};

/// An order of the rays of a batch that hit something: those that hit the same primitive are
/// neighbours, as far as is worth while.
class HitOrder {
  public:
    /// Finds the order of a batch.
    void find(std::span<const Hit> hits);

    /// All rays that hit something; padded with numbers of some.
    std::vector<std::uint32_t> rays;
    /// Rays that hit one primitive, those of no instance. They come first in the order, one run
    /// after another.
    std::vector<HitRun> runs;
    std::size_t in_runs = 0;  ///< number of rays in runs
    std::size_t size = 0;     ///< of the order

  private:
    /// Neighbours that have hit the same primitive: all from `first` to before `last`.
    struct Neighbours {
        std::uint32_t first, last;
        std::uint32_t next;  ///< number of those that have hit it after them
    };

    /// All that have hit a primitive, as a list of such.
    struct PrimitiveHits {
        std::uint32_t primitive = no_index;
        std::uint32_t count = 0;
        std::uint32_t first = no_index, last = no_index;
    };

    void add(const Neighbours& some, const Hit& hit);
    std::size_t append(const Neighbours& some, std::size_t at);
    std::size_t append(const PrimitiveHits& list, std::size_t at);

    /// A list for each of as many primitives. Of those with the same place in it, one has it.
    std::array<PrimitiveHits, 128> table_;
    std::vector<Neighbours> neighbours_, others_;
};

}  // namespace etalon
