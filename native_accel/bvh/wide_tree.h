#pragma once

#include <vector>

#include "core/accel/tree/node.h"
#include "native_accel/common/wide_node.h"

namespace etalon {

/// Nodes in depth-first order but for siblings, which are together; and where to begin.
struct WideTree {
    bool empty() const { return nodes.empty() && !root.is_leaf(); }

    std::vector<WideNode, LargePages<WideNode>> nodes;
    ChildRef root;
    /// Mean number of nodes that a random line through the root's box enters, by their surfaces.
    double expected_nodes = 1;
};

/// Places a binary tree's nodes up to eight to one. A binary leaf's `first` says which of `leaves`
/// it becomes. The tree, in the order of BvhTree, must not be empty. On as many threads as allowed.
WideTree widen(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves);

}  // namespace etalon
