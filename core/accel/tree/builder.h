// A binary BVH from boxes alone: the builder knows no shape, ray or scene.
#pragma once

#include <vector>

#include "core/accel/tree/leaf_cost.h"
#include "core/accel/tree/node.h"

namespace etalon {

struct BvhConfig {
    int bins = 32;  ///< candidate planes per axis, plus one; at most 32, fewer in small nodes
    std::uint32_t max_leaf = 8;  ///< a leaf never holds more, whatever the heuristic says
    LeafCosts leaf_costs = default_leaf_costs();
    std::size_t serial_below = 4096;  ///< larger subtrees are more than one thread's work
};

/// Depth limits of any tree: so many levels by the heuristic, then at most 32 that halve what is
/// left.
inline constexpr int bvh_heuristic_depth = 40;
inline constexpr int bvh_max_depth = bvh_heuristic_depth + 32;

struct BvhTree {
    /// Nodes depth first, left before right, but the children of a node are together. nodes[0]
    /// is the root; nodes[1] pads it to a pair; empty if no primitive.
    std::vector<BvhNode> nodes;
    std::vector<std::uint32_t> ids;  ///< primitive numbers in the order of the leaves
};

/// Builds top-down by binned surface area heuristic (Wald 2007, "On fast Construction of SAH-based
/// Bounding Volume Hierarchies"), on as many threads as allowed. A leaf's primitives are of one
/// kind. The tree is the same, bit for bit, for any number of threads.
BvhTree build_bvh(std::vector<BoundedPrimitive> primitives, const BvhConfig& config = {});

}  // namespace etalon
