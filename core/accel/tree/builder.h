// A binary BVH built from boxes alone: the builder knows no shape, ray or scene.
#pragma once

#include <vector>

#include "core/accel/tree/leaf_cost.h"
#include "core/accel/tree/node.h"

namespace etalon {

struct BvhConfig {
    int bins = 32;  ///< candidate planes per axis, plus one; at most 32, fewer in small nodes
    std::uint32_t max_leaf = 8;  ///< most primitives of a leaf, whatever the heuristic says
    LeafCosts leaf_costs = default_leaf_costs();
    std::size_t serial_below = 4096;  ///< subtrees of fewer primitives are built by one thread
};

/// Builds this many levels by the heuristic, then at most 32 that halve the remaining sets.
inline constexpr int bvh_heuristic_depth = 40;

/// Depth limit of any tree, for the stacks of traversals. Nested sizes are best in a chain: see
/// reinsertion.h.
inline constexpr int bvh_max_depth = 128;

struct BvhTree {
    /// Nodes in depth-first order, left before right, but the children of a node are adjacent.
    /// nodes[0] is the root and nodes[1] unused. Empty if there is no primitive.
    std::vector<BvhNode> nodes;
    std::vector<std::uint32_t> ids;  ///< primitive numbers in the order of the leaves
};

/// Builds top-down by binned surface area heuristic (Wald 2007, "On fast Construction of SAH-based
/// Bounding Volume Hierarchies"), on as many threads as allowed. A leaf's primitives are of one
/// kind. The tree is the same, bit for bit, for any number of threads.
BvhTree build_bvh(std::vector<BoundedPrimitive> primitives, const BvhConfig& config = {});

}  // namespace etalon
