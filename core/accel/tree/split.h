#pragma once

#include "core/accel/tree/binning.h"

namespace etalon {

/// Split of a set: primitives whose bin along `axis` is below `bin` go left.
struct Split {
    float cost = std::numeric_limits<float>::infinity();  ///< of two leaves, times surface area
    int axis = -1;                                        ///< -1 if no plane divides the set
    int bin = 0;
};

/// Returns the plane between two bins of least cost by the surface area heuristic.
Split cheapest_split(const Bins& bins, const LeafWeights& weights);

inline constexpr std::size_t few_primitives = 8;

/// Returns the same for up to few_primitives, which are sorted by their bins, as most of these
/// would be empty.
Split cheapest_split(std::span<const BoundedPrimitive> few, const Binning& binning,
                     const LeafWeights& weights);

/// Sums over the primitives on both sides of a split.
struct SplitSides {
    Bin left, right;
};
SplitSides sides(const Bins& bins, const Split& split);
SplitSides sides(std::span<const BoundedPrimitive> primitives, const Binning& binning,
                 const LeafWeights& weights, const Split& split);

}  // namespace etalon
