// Comparison of two tracers' answers to the same rays.
#pragma once

#include <span>
#include <vector>

#include "bench/speed/tracing.h"

namespace etalon::speed {

/// Numbers of rays for which answers differ. A ray counts once, for the first of these that
/// applies.
struct Disagreement {
    std::size_t rays = 0;
    std::size_t hit_or_miss = 0;  ///< one hits, the other misses
    std::size_t primitive = 0;    ///< both hit, but different primitives
    std::size_t distance = 0;     ///< the same primitive, but t has different bits

    std::size_t total() const { return hit_or_miss + primitive + distance; }
};

/// Compares answers to the rays of one set, in its order; for occlusion queries only hit or miss.
Disagreement compare(std::span<const Answer> answers, std::span<const Answer> reference,
                     bool occlusion);

/// Returns the indices of the rays to which not all tracers have the same answer, apart from the
/// bits of t. All lists must be as long as the first.
std::vector<std::size_t> disputed(const std::vector<std::vector<Answer>>& answers, bool occlusion);

}  // namespace etalon::speed
