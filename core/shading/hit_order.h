#pragma once

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
struct HitOrder {
    explicit HitOrder(std::span<const Hit> hits);

    std::vector<std::uint32_t> rays;
    /// Rays that hit one primitive, those of no instance. They come first in the order, one run
    /// after another.
    std::vector<HitRun> runs;
    std::size_t in_runs = 0;  ///< number of rays in runs
};

}  // namespace etalon
