#pragma once

#include <span>

#include "core/accel/tree/bounds.h"

namespace etalon {

/// Neighbouring primitives that become a subtree.
struct PrimitiveSet {
    std::size_t size() const { return primitives.size(); }

    void extend(const Bounds& b) {
        bounds.extend(b);
        centres.extend(twice_centre(b));
    }
    void extend(const PrimitiveSet& other) {
        bounds.extend(other.bounds);
        centres.extend(other.centres);
    }

    std::span<BoundedPrimitive> primitives;
    Bounds bounds;   ///< bounds of all boxes
    Bounds centres;  ///< bounds of twice their centres
};

struct SplitSets {
    PrimitiveSet left, right;
};

/// Returns the set with its bounds.
inline PrimitiveSet with_bounds(std::span<BoundedPrimitive> primitives) {
    PrimitiveSet set{primitives, {}, {}};
    for (const BoundedPrimitive& p : primitives) set.extend(Bounds::of(p));
    return set;
}

}  // namespace etalon
