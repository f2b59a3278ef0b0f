#include "core/accel/tree/split.h"

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/accel/tree/split.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Returns the cost of a leaf, times half the surface area of its box.
HWY_INLINE float leaf_cost(const Bin& bin, const LeafWeights& weights) {
    return bin.bounds.half_area() * weights.cost(bin.weight);
}

/// Returns the cheapest plane of one axis, by sweeping areas from both ends.
HWY_INLINE Split cheapest_along(const Bins& bins, const LeafWeights& weights, int axis) {
    std::array<float, max_bins> right_cost;
    Bin right;
    for (int i = bins.size() - 1; i > 0; --i) {
        right.add(bins.at(axis, i));
        right_cost[i] = right.count == 0 ? Split().cost : leaf_cost(right, weights);
    }
    Split best;
    Bin left;
    for (int i = 1; i < bins.size(); ++i) {
        left.add(bins.at(axis, i - 1));
        if (left.count == 0) continue;
        const float cost = leaf_cost(left, weights) + right_cost[i];
        if (cost < best.cost) best = {cost, axis, i};
    }
    return best;
}

Split cheapest_split(const Bins& bins, const LeafWeights& weights) {
    Split best;
    for (int k = 0; k < 3; ++k) {
        const Split split = cheapest_along(bins, weights, k);
        if (split.cost < best.cost) best = split;
    }
    return best;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(cheapest_split);

Split cheapest_split(const Bins& bins, const LeafWeights& weights) {
    return HWY_DYNAMIC_DISPATCH(cheapest_split)(bins, weights);
}

}  // namespace etalon
#endif
