// Partitioning of primitives by a split.
#pragma once

#include "core/accel/tree/primitive_set.h"
#include "core/accel/tree/split.h"

namespace etalon {

/// Reorders primitives by a split with the given sides, without data-dependent branches.
SplitSets partition(std::span<BoundedPrimitive> primitives, const Binning& binning,
                    const Split& split, const SplitSides& sides);

/// Bounds of the centres on both sides of a split.
struct SideCentres {
    /// Extends one side. The other is extended by a point that changes nothing, to avoid a branch.
    void extend(Bounds::Corner centre, bool is_left) {
        using Mask = std::int32_t __attribute__((vector_size(16)));
        const Mask here = Mask{} - static_cast<std::int32_t>(is_left);
        const Bounds nothing;
        left.min = Bounds::lower(left.min, here ? centre : nothing.min);
        left.max = Bounds::upper(left.max, here ? centre : nothing.max);
        right.min = Bounds::lower(right.min, here ? nothing.min : centre);
        right.max = Bounds::upper(right.max, here ? nothing.max : centre);
    }
    void extend(const SideCentres& other) {
        left.extend(other.left);
        right.extend(other.right);
    }

    Bounds left, right;
};

/// Copies primitives to two places, in order, and never past the end of either.
SideCentres scatter(std::span<const BoundedPrimitive> primitives, const Binning& binning,
                    const Split& split, BoundedPrimitive* left, BoundedPrimitive* right);

/// Moves the smaller boxes to the front, for sets that no plane between centres divides. Returns
/// how many these are.
std::size_t smaller_half(std::span<BoundedPrimitive> primitives);

}  // namespace etalon
