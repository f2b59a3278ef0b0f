// Partitioning of sets of so many primitives that all threads work at one of them.
#pragma once

#include "core/accel/tree/builder.h"
#include "core/accel/tree/partition.h"

namespace etalon {

/// Summary of all primitives before the first split.
struct BoundsSummary {
    void add(const BoundsSummary& other);

    PrimitiveSet set;
    std::array<std::size_t, item_kinds> of_kind{};  ///< number of primitives of each kind
};

BoundsSummary summarize_bounds(std::span<BoundedPrimitive> primitives);

/// A set divided, and an array as large as the set that neither half is in.
struct SplitResult {
    SplitSets halves;
    std::span<BoundedPrimitive> spare;
};

/// Divides by the surface area heuristic, into `spare`; by size, in place, where that finds no
/// plane, and if `in_halves`.
SplitResult split_large(const PrimitiveSet& set, std::span<BoundedPrimitive> spare, bool in_halves,
                        const BvhConfig& config, const LeafWeights& weights);

}  // namespace etalon
