#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "native_accel/bvh/wide_node.h"

namespace etalon {

/// Which nodes of a binary tree stay when each takes up to node_width of its descendants for
/// children: those of the least total surface, which is what visiting them costs, by dynamic
/// programming (Ylitie, Karras & Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through
/// Compressed Wide BVHs", section 3.1). Leaves stay as they are.
class Collapse {
  public:
    explicit Collapse(const std::vector<BvhNode>& nodes);

    /// The descendants that become the children of the inner node `node`.
    std::vector<const BvhNode*> children(const BvhNode& node) const;

  private:
    /// For a node: the least cost of standing for it with so many nodes or fewer, and how many of
    /// them are below its first child; 0 where one fewer does as well.
    struct Plan {
        std::array<float, node_width> cost;  ///< from 1 on
        std::array<std::uint8_t, node_width + 1> first{};
    };

    Plan plan(const BvhNode& node) const;
    void gather(const BvhNode& node, std::size_t count, std::vector<const BvhNode*>& list) const;

    const std::vector<BvhNode>& nodes_;
    std::vector<Plan> plans_;
};

}  // namespace etalon
