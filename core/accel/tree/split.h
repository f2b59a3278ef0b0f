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

}  // namespace etalon
