#pragma once

#include "core/accel/tree/splitter.h"

namespace etalon {

/// Builds a subtree on a single thread. As in BvhTree, nodes[0] is the root and nodes[1] unused.
/// The leaves' primitives are indices into the whole tree's ids, which the builder fills in.
class SubtreeBuilder {
  public:
    SubtreeBuilder(const BvhConfig& config, const LeafWeights& weights, std::uint32_t* all_ids)
        : splitter_(config, weights), all_ids_(all_ids) {}

    /// Builds the tree of a set that starts at index `first` of the whole, `depth` levels below the
    /// root.
    std::vector<BvhNode> build(const PrimitiveSet& set, std::size_t first, int depth);

  private:
    void build_node(std::uint32_t node, const PrimitiveSet& set, int depth);
    void make_leaf(BvhNode& node, std::span<const BoundedPrimitive> primitives);

    Splitter splitter_;
    std::uint32_t* all_ids_;
    std::size_t next_id_ = 0;
    std::vector<BvhNode> nodes_;
};

}  // namespace etalon
