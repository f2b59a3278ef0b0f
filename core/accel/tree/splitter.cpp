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
    bins_.count(binning, set.primitives, weights_);
    const Split split = cheapest_split(bins_, weights_);
    if (is_small && !pays(split, set)) {
        if (may_end) return std::nullopt;
        return divide_by_kind(set.primitives);
    }
    if (split.axis < 0) return divide_at(set.primitives, smaller_half(set.primitives));
    return partition(set.primitives, binning, bins_, split);
}

/// Returns whether a set is tested at once, so that dividing it would gain next to nothing.
bool Splitter::fills_one_test(const PrimitiveSet& set) const {
    return set.size() <= config_.leaf_costs[set.primitives.front().kind].lanes;
}

bool Splitter::pays(const Split& split, const PrimitiveSet& set) const {
    const float area = set.bounds.half_area();
    const std::uint64_t weight = bins_.sum(0, 0, bins_.size()).weight;
    return area + split.cost < area * weights_.cost(weight);
}

}  // namespace etalon
