#include "core/accel/tree/scene_tree.h"

#include "core/accel/tree/presplit.h"

namespace etalon {
namespace {

/// Returns the cost by the surface area heuristic, to compare trees of the same primitives.
double cost(const BvhTree& tree, const Geometry& geometry, const LeafCosts& costs) {
    double sum = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (i == 1) continue;
        const BvhNode& node = tree.nodes[i];
        if (node.is_leaf()) {
            const LeafCost& c = costs[geometry.kind_of_item(tree.ids[node.first])];
            const double tests = (node.count + c.lanes - 1) / c.lanes;
            sum += half_area(node.box) * c.cost * tests;
        } else {
            sum += half_area(node.box);
        }
    }
    return sum;
}

}  // namespace

/// Uses pieces only for a clear gain, which must pay for more leaves and nodes than the caches
/// hold. The tree of all primitives costs no less than that of the ones to be cut alone, which
/// often suffices to decide.
BvhTree build_scene_bvh(const Geometry& geometry, const NormalizedSpace& space,
                        std::vector<BoundedPrimitive> primitives, const BvhConfig& config) {
    constexpr double clear_gain = 0.8;
    auto pieces = presplit(geometry, space, primitives);
    if (!pieces) return build_bvh(std::move(primitives), config);
    BvhTree split = build_bvh(std::move(pieces->references), config);
    const auto pays = [&](const BvhTree& whole) {
        return cost(split, geometry, config.leaf_costs) <
               clear_gain * cost(whole, geometry, config.leaf_costs);
    };
    if (pays(build_bvh(std::move(pieces->cut), config))) return split;
    BvhTree whole = build_bvh(std::move(primitives), config);
    return pays(whole) ? std::move(split) : std::move(whole);
}

}  // namespace etalon
