#pragma once

#include "core/accel/tree/binning.h"

namespace etalon {

/// Primitives whose bin along `axis` is below `bin` go left.
struct Split {
    float cost = std::numeric_limits<float>::infinity();  ///< cost as two leaves, times area
    int axis = -1;                                        ///< no plane divides the set
    int bin = 0;
};

/// The plane between two bins that the surface area heuristic likes best.
Split cheapest_split(const Bins& bins, const LeafWeights& weights);

}  // namespace etalon
