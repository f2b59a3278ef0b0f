#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/accel/wide/wide_tree.h"

namespace etalon {

/// A subtree of a binary tree: its root, with the nodes below in the range from its first child to
/// before `end`, in the order of BvhTree.
struct Branch {
    bool is_leaf() const { return node->is_leaf(); }

    /// Returns the number of nodes below it.
    std::size_t size() const { return is_leaf() ? 0 : end - node->first; }

    const BvhNode* node;
    std::size_t end;
};

/// List of up to node_width branches.
struct Branches {
    void push_back(const Branch& branch) { all[count++] = branch; }
    Branch* begin() { return all.data(); }
    Branch* end() { return all.data() + count; }

    std::array<Branch, node_width> all;
    std::size_t count = 0;
};

/// Chooses which nodes of a binary tree remain when each takes up to node_width descendants as its
/// children. Minimizes the total surface area of the remaining nodes, which is the cost of visiting
/// them, by dynamic programming (Ylitie, Karras & Laine 2017, "Efficient Incoherent Ray Traversal
/// on GPUs Through Compressed Wide BVHs", section 3.1). Leaves stay as they are. Runs on as many
/// threads as allowed.
class Collapse {
  public:
    /// The tree must not be empty.
    explicit Collapse(const std::vector<BvhNode>& nodes);

    Branch root() const { return {nodes_.data(), nodes_.size()}; }

    /// Returns half the surface area of all inner nodes that remain.
    float surface() const { return plan_or_none(nodes_.front()).cost[1]; }

    /// Returns the descendants that become the children of an inner node.
    Branches children(const Branch& branch) const;

  private:
    /// Least cost of replacing a node by at most n nodes, and how many of these are below its first
    /// child; 0 if n - 1 nodes are as good.
    struct Plan {
        std::array<float, node_width> cost;  ///< by number of nodes, from 1
        std::array<std::uint8_t, node_width + 1> first;
    };

    static constexpr Plan no_plan{};  ///< of a leaf

    std::array<Branch, 2> halves(const Branch& branch) const;
    void plan_all(const Branch& branch);
    Plan plan(const BvhNode& inner) const;
    void gather(const Branch& branch, std::size_t count, Branches& list) const;
    Plan& plan_of(const BvhNode& inner) const { return plans_[inner.first / 2]; }
    const Plan& plan_or_none(const BvhNode& node) const {
        return node.is_leaf() ? no_plan : plan_of(node);
    }

    const std::vector<BvhNode>& nodes_;
    std::unique_ptr<Plan[]> plans_;  ///< one for each pair of children
};

}  // namespace etalon
