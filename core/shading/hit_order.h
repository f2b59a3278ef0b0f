#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/intersect/ray.h"

namespace etalon {

/// Rays that hit one primitive: the positions [first, last) of a HitOrder.
struct HitRun {
    std::uint32_t first, last;
    std::uint32_t primitive;
};

/// An order of the rays of a batch that hit something. Rays that hit the same primitive are mostly
/// adjacent, so that vector instructions can shade them together.
class HitOrder {
  public:
    /// Finds the order of a batch.
    void find(std::span<const Hit> hits);

    /// The rays that hit something, in this order; padded with valid ray numbers.
    std::vector<std::uint32_t> rays;
    /// Runs of rays that hit one primitive outside of instances. They are adjacent and come first
    /// in the order.
    std::vector<HitRun> runs;
    std::size_t in_runs = 0;  ///< number of rays in runs
    std::size_t size = 0;     ///< number of rays in the order

  private:
    /// Consecutive rays of the batch that hit the same primitive: those in [first, last).
    struct Neighbours {
        std::uint32_t first, last;
        std::uint32_t next;  ///< index of the next such rays on the primitive
    };

    /// Linked list of all rays that hit one primitive.
    struct PrimitiveHits {
        std::uint32_t primitive = no_index;
        std::uint32_t count = 0;
        std::uint32_t first = no_index, last = no_index;
    };

    void add(const Neighbours& some, const Hit& hit);
    std::size_t append(const Neighbours& some, std::size_t at);
    std::size_t append(const PrimitiveHits& list, std::size_t at);

    /// Hash table of lists. Of primitives with the same hash only the first has a list; the rays of
    /// the rest go to `others_`.
    std::array<PrimitiveHits, 128> table_;
    std::vector<std::uint32_t> used_;  ///< numbers of the lists that have rays
    std::vector<Neighbours> neighbours_, others_;
};

}  // namespace etalon
