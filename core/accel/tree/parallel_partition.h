// Partitioning of sets so large that all threads work on one of them.
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

/// The two halves of a divided set, and an array as large as the set that neither half uses.
struct SplitResult {
    SplitSets halves;
    std::span<BoundedPrimitive> spare;
};

/// Divides a set by the surface area heuristic, into `spare`. Divides it by size, in place, if
/// `in_halves` or if the heuristic finds no plane.
SplitResult split_large(const PrimitiveSet& set, std::span<BoundedPrimitive> spare, bool in_halves,
                        const BvhConfig& config, const LeafWeights& weights);

}  // namespace etalon
