// Merging of the subtrees that parallel tasks build.
#pragma once

#include <memory>
#include <vector>

#include "core/accel/tree/node.h"

namespace etalon {

/// A subtree that one task built, or a node whose children are such parts.
struct Part {
    Box3f box;
    std::vector<BvhNode> nodes;  ///< nodes of a subtree; nodes[1] is not used
    std::unique_ptr<Part> left, right;
};

/// Concatenates all nodes, with the children of a node adjacent, in an order that depends on the
/// tree alone. nodes[1] is not used.
std::vector<BvhNode> merge_subtrees(const Part& root);

}  // namespace etalon
