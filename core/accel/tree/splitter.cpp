#include "core/accel/tree/splitter.h"

#include <algorithm>

namespace etalon {
namespace {

bool is_of_one_kind(std::span<const BoundedPrimitive> primitives) {
    return std::all_of(primitives.begin(), primitives.end(), [&](const BoundedPrimitive& p) {
        return p.kind == primitives.front().kind;
    });
}

SplitSets divide_at(std::span<BoundedPrimitive> primitives, std::size_t middle) {
    return {with_bounds(primitives.first(middle)), with_bounds(primitives.subspan(middle))};
}

/// Divides a set by kind: primitives of the first one's kind go left.
SplitSets divide_by_kind(std::span<BoundedPrimitive> primitives) {
    const std::uint32_t kind = primitives.front().kind;
    const auto middle = std::partition(primitives.begin(), primitives.end(),
                                       [&](const BoundedPrimitive& p) { return p.kind == kind; });
    return divide_at(primitives, static_cast<std::size_t>(middle - primitives.begin()));
}

}  // namespace

int bins_for(std::size_t primitives, const BvhConfig& config) {
    return static_cast<int>(
        std::min<std::size_t>(16 + primitives / 4, static_cast<std::size_t>(config.bins)));
}

std::optional<SplitSets> Splitter::split(const PrimitiveSet& set, int depth) {
    const bool is_small = set.size() <= config_.max_leaf;
    const bool may_end = is_small && is_of_one_kind(set.primitives);
    if (may_end && fills_one_test(set)) return std::nullopt;
    if (depth >= bvh_heuristic_depth) {
        if (may_end) return std::nullopt;
        return divide_at(set.primitives, smaller_half(set.primitives));
    }
    const Binning binning(set.centres, bins_for(set.size(), config_));
    const Split split = cheapest(set, binning);
    if (split.axis < 0 && !is_small) {
        return divide_at(set.primitives, smaller_half(set.primitives));
    }
    if (is_small && !pays(split, set)) {
        if (may_end) return std::nullopt;
        return divide_by_kind(set.primitives);
    }
    return partition(set.primitives, binning, split, sides_of(set, binning, split));
}

/// Counts the bins only of sets that are not small.
Split Splitter::cheapest(const PrimitiveSet& set, const Binning& binning) {
    if (set.size() <= few_primitives) return cheapest_split(set.primitives, binning, weights_);
    bins_.count(binning, set.primitives, weights_);
    return cheapest_split(bins_, weights_);
}

SplitSides Splitter::sides_of(const PrimitiveSet& set, const Binning& binning,
                              const Split& split) const {
    return set.size() <= few_primitives ? sides(set.primitives, binning, weights_, split)
                                        : sides(bins_, split);
}

/// Returns whether a set is tested at once, so that dividing it would gain next to nothing.
bool Splitter::fills_one_test(const PrimitiveSet& set) const {
    return set.size() <= config_.leaf_costs[set.primitives.front().kind].lanes;
}

bool Splitter::pays(const Split& split, const PrimitiveSet& set) const {
    const float area = set.bounds.half_area();
    std::uint64_t weight = 0;
    for (const BoundedPrimitive& p : set.primitives) weight += weights_.weight(p.kind);
    return area + split.cost < area * weights_.cost(weight);
}

}  // namespace etalon
