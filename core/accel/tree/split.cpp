#include "core/accel/tree/split.h"

#include <algorithm>

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

/// A primitive of a few.
struct Member {
    Bounds bounds;
    std::uint32_t weight;
    std::array<std::int32_t, 4> bins;
};

/// Primitives in the order of their bins along one axis.
class MembersInOrder {
  public:
    HWY_INLINE MembersInOrder(std::span<const Member> members, int axis) : axis_(axis) {
        for (std::size_t i = 0; i < members.size(); ++i) {
            std::size_t at = i;
            for (; at > 0 && bin(at - 1) > members[i].bins[axis]; --at) all_[at] = all_[at - 1];
            all_[at] = &members[i];
        }
    }

    HWY_INLINE const Member& operator[](std::size_t i) const { return *all_[i]; }
    HWY_INLINE int bin(std::size_t i) const { return all_[i]->bins[axis_]; }

  private:
    int axis_;
    std::array<const Member*, few_primitives> all_;
};

HWY_INLINE Split cheapest_along(std::span<const Member> members, const LeafWeights& weights,
                                int axis) {
    const MembersInOrder ordered(members, axis);
    std::array<float, few_primitives> right_cost;
    Bin right;
    for (std::size_t i = members.size(); --i > 0;) {
        right.add(ordered[i].bounds, ordered[i].weight);
        right_cost[i] = leaf_cost(right, weights);
    }
    Split best;
    Bin left;
    for (std::size_t i = 1; i < members.size(); ++i) {
        left.add(ordered[i - 1].bounds, ordered[i - 1].weight);
        if (ordered.bin(i - 1) == ordered.bin(i)) continue;
        const float cost = leaf_cost(left, weights) + right_cost[i];
        if (cost < best.cost) best = {cost, axis, ordered.bin(i - 1) + 1};
    }
    return best;
}

HWY_INLINE float leaf_cost(const Member& m, const LeafWeights& weights) {
    return m.bounds.half_area() * weights.cost(m.weight);
}

/// Any plane between two primitives costs the same, so that the first axis is as good as any.
HWY_INLINE Split split_of_two(const Member& a, const Member& b, const LeafWeights& weights) {
    Split split;
    for (int k = 0; k < 3 && split.axis < 0; ++k) {
        if (a.bins[k] == b.bins[k]) continue;
        split = {leaf_cost(a, weights) + leaf_cost(b, weights), k,
                 std::min(a.bins[k], b.bins[k]) + 1};
    }
    return split;
}

Split cheapest_split_of_few(std::span<const BoundedPrimitive> few, const Binning& binning,
                            const LeafWeights& weights) {
    using Numbers = std::int32_t __attribute__((vector_size(16)));
    std::array<Member, few_primitives> members;
    for (std::size_t i = 0; i < few.size(); ++i) {
        const Bounds b = Bounds::of(few[i]);
        const auto bins = __builtin_convertvector(binning.positions(b), Numbers);
        members[i].bounds = b;
        members[i].weight = weights.weight(few[i].kind);
        std::memcpy(members[i].bins.data(), &bins, sizeof(bins));
    }
    if (few.size() == 2) return split_of_two(members[0], members[1], weights);
    Split best;
    for (int k = 0; k < 3; ++k) {
        const Split split = cheapest_along(std::span(members.data(), few.size()), weights, k);
        if (split.cost < best.cost) best = split;
    }
    return best;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(cheapest_split);
HWY_EXPORT(cheapest_split_of_few);

Split cheapest_split(const Bins& bins, const LeafWeights& weights) {
    return HWY_DYNAMIC_DISPATCH(cheapest_split)(bins, weights);
}

Split cheapest_split(std::span<const BoundedPrimitive> few, const Binning& binning,
                     const LeafWeights& weights) {
    return HWY_DYNAMIC_DISPATCH(cheapest_split_of_few)(few, binning, weights);
}

SplitSides sides(const Bins& bins, const Split& split) {
    return {bins.sum(split.axis, 0, split.bin), bins.sum(split.axis, split.bin, bins.size())};
}

SplitSides sides(std::span<const BoundedPrimitive> primitives, const Binning& binning,
                 const LeafWeights& weights, const Split& split) {
    SplitSides result;
    for (const BoundedPrimitive& p : primitives) {
        const Bounds b = Bounds::of(p);
        const bool is_left = binning.is_below(b, split.axis, static_cast<float>(split.bin));
        (is_left ? result.left : result.right).add(b, weights.weight(p.kind));
    }
    return result;
}

}  // namespace etalon
#endif
