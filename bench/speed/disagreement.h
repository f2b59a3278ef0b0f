// Comparison of two tracers' answers to the same rays.
#pragma once

#include <span>
#include <vector>

#include "bench/speed/tracing.h"

namespace etalon::speed {

/// Each ray is counted once, for the first of these that holds.
struct Disagreement {
    std::size_t rays = 0;
    std::size_t hit_or_miss = 0;  ///< one hits, the other misses
    std::size_t primitive = 0;    ///< both hit, but not the same
    std::size_t distance = 0;     ///< the same, at a t of other bits

    std::size_t total() const { return hit_or_miss + primitive + distance; }
};

/// Both to the rays of one set, in its order; of occlusion queries only hit or miss is compared.
Disagreement compare(std::span<const Answer> answers, std::span<const Answer> reference,
                     bool occlusion);

/// The places of the rays to which not all have the same answer, the bits of t apart. All lists are
/// as long as the first.
std::vector<std::size_t> disputed(const std::vector<std::vector<Answer>>& answers, bool occlusion);

}  // namespace etalon::speed
