// Costs of testing primitives, for the surface area heuristic.
#pragma once

#include <array>
#include <span>

#include "core/intersect/bounded.h"

namespace etalon {

/// Cost of testing up to `lanes` primitives of a kind, relative to visiting a node.
struct LeafCost {
    std::uint32_t lanes;
    float cost;
};

using LeafCosts = std::array<LeafCost, item_kinds>;

/// Returns the costs where triangles and spheres are filtered eight at once and others tested one
/// by one. A curve is halved many times, and for an instance a tree is traversed.
constexpr LeafCosts default_leaf_costs() {
    LeafCosts costs{};
    costs.fill({1, 2.0F});
    costs[kind_of<Triangle>()] = costs[kind_of<Sphere>()] = {8, 0.7F};
    costs[kind_of<Curve>()] = {1, 6.0F};
    costs[instance_kind] = {1, 8.0F};
    return costs;
}

/// Costs as sums of integers, one for each primitive, which are the same in any order. A block, the
/// number of primitives of the commonest kind that are tested at once, has a fixed sum, and sums
/// are rounded up to blocks: exact for a scene of one kind, and close enough for others.
class LeafWeights {
  public:
    LeafWeights(const LeafCosts& costs, ShapeKind commonest) : block_cost_(costs[commonest].cost) {
        for (std::size_t kind = 0; kind < item_kinds; ++kind) {
            const float blocks =
                costs[kind].cost / (block_cost_ * static_cast<float>(costs[kind].lanes));
            weights_[kind] = std::max(1U, static_cast<std::uint32_t>(block * blocks));
        }
    }

    std::uint32_t weight(std::uint32_t kind) const { return weights_[kind]; }

    /// Returns the cost of testing primitives whose weights add up to `sum`.
    float cost(std::uint64_t sum) const {
        return block_cost_ *
               static_cast<float>(static_cast<std::int64_t>((sum + block - 1) / block));
    }

  private:
    static constexpr std::uint64_t block = 64;

    float block_cost_;
    std::array<std::uint32_t, item_kinds> weights_{};
};

}  // namespace etalon
