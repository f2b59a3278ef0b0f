#pragma once

#include <vector>

#include "core/accel/tree/builder.h"
#include "core/accel/wide/wide_node.h"

namespace etalon {

/// Nodes in depth-first order, except that siblings are adjacent, and the reference to the root.
struct WideTree {
    bool empty() const { return nodes.empty() && !root.is_leaf(); }

    std::vector<WideNode, LargePages<WideNode>> nodes;
    ChildRef root;
    /// Mean number of nodes that a random line through the root's box enters, from their surface
    /// areas.
    double expected_nodes = 1;
};

/// Stores each leaf's number in its `first`, as widen() expects, and returns the primitives of each
/// leaf.
std::vector<Range> number_leaves(BvhTree& tree);

/// Collapses a binary tree into nodes of up to eight children. The `first` of a binary leaf is its
/// index in `leaves`. The tree, in the order of BvhTree, must not be empty. Uses as many threads as
/// allowed.
WideTree widen(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves);

}  // namespace etalon
