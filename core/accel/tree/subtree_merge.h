// A tree in the parts that tasks build.
#pragma once

#include <memory>
#include <vector>

#include "core/accel/tree/node.h"

namespace etalon {

/// A subtree that one task built, or a node whose children are parts of their own.
struct Part {
    Box3f box;
    std::vector<BvhNode> nodes;  ///< nodes of a subtree; nodes[1] is not used
    std::unique_ptr<Part> left, right;
};

/// Puts all nodes side by side, the children of a node next to each other, in an order that depends
/// on the tree alone. nodes[1] is not used.
std::vector<BvhNode> merge_subtrees(const Part& root);

}  // namespace etalon
