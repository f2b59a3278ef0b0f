#include "core/intersect/tree/scene_tree.h"

#include "core/intersect/tree/presplit.h"

namespace etalon {
namespace {

/// By the surface area heuristic, of trees about the same primitives.
double cost(const BvhTree& tree, const Scene& scene, const LeafCosts& costs) {
    double sum = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (i == 1) continue;
        const BvhNode& node = tree.nodes[i];
        if (node.is_leaf()) {
            const LeafCost& c = costs[scene.primitives[tree.ids[node.first]].kind];
            const double tests = (node.count + c.lanes - 1) / c.lanes;
            sum += half_area(node.box) * c.cost * tests;
        } else {
            sum += half_area(node.box);
        }
    }
    return sum;
}

}  // namespace

/// Whatever is gained must also pay for more leaves and nodes than stay in the caches.
BvhTree build_scene_bvh(const Scene& scene, const Frame& frame,
                        std::vector<BoundedPrimitive> primitives, const BvhConfig& config) {
    constexpr double clear_gain = 0.8;
    auto pieces = presplit(scene, frame, primitives);
    BvhTree whole = build_bvh(std::move(primitives), config);
    if (!pieces) return whole;
    BvhTree split = build_bvh(std::move(*pieces), config);
    const bool pays =
        cost(split, scene, config.leaf_costs) < clear_gain * cost(whole, scene, config.leaf_costs);
    return pays ? std::move(split) : std::move(whole);
}

}  // namespace etalon
