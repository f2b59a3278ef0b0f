#include "core/accel/tree/subtree.h"

namespace etalon {

std::vector<BvhNode> SubtreeBuilder::build(const PrimitiveSet& set, std::size_t first, int depth) {
    next_id_ = first;
    nodes_.reserve(2 + set.size() / 2);
    nodes_.resize(2);
    build_node(0, set, depth);
    return std::move(nodes_);
}

/// Leaves are built from left to right, so their primitives fill `all_ids` in order.
void SubtreeBuilder::build_node(std::uint32_t node, const PrimitiveSet& set, int depth) {
    nodes_[node].box = set.bounds.box();
    const std::optional<SplitSets> halves = splitter_.split(set, depth);
    if (!halves) return make_leaf(nodes_[node], set.primitives);
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = child;
    nodes_[node].count = 0;
    nodes_.resize(child + 2);
    build_node(child, halves->left, depth + 1);
    build_node(child + 1, halves->right, depth + 1);
}

void SubtreeBuilder::make_leaf(BvhNode& node, std::span<const BoundedPrimitive> primitives) {
    node.first = static_cast<std::uint32_t>(next_id_);
    node.count = static_cast<std::uint32_t>(primitives.size());
    for (const BoundedPrimitive& p : primitives) all_ids_[next_id_++] = p.id;
}

}  // namespace etalon
