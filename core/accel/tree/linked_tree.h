#pragma once

#include <array>
#include <vector>

#include "core/accel/tree/bounds.h"
#include "core/accel/tree/builder.h"

namespace etalon {

/// The top of a binary tree, whose subtrees can be moved: nodes know their parents. Below its
/// lowest nodes the tree stays as it is.
class LinkedTree {
  public:
    using Index = std::uint32_t;
    static constexpr Index none = ~Index{0};

    struct Node {
        bool is_lowest() const { return children[0] == none; }

        Bounds bounds;
        Index parent = none;  ///< none for the root
        std::array<Index, 2> children = {none, none};
        Index source = 0;  ///< number of a lowest node in the whole tree
        int height = 0;    ///< levels below it in the whole tree
    };

    /// Takes the root and up to `most` nodes in all, those of largest surface area. The tree must
    /// not be empty, and exist as long as this.
    LinkedTree(const BvhTree& whole, std::size_t most);

    const std::vector<Node>& nodes() const { return nodes_; }
    const Node& operator[](Index node) const { return nodes_[node]; }

    /// Returns half the surface area of all nodes that have children here, in units of the root's.
    double surface() const;

    /// Returns how much half the surface area of all nodes grows if a box is put beside a node.
    float growth(Index node, const Bounds& box) const;

    /// Returns whether no leaf gets deeper than bvh_max_depth if one node is put beside another.
    bool may_attach(Index node, Index beside) const;

    /// Takes out a node that is at least two levels below the root, with its parent, whose other
    /// child takes the parent's place. Returns that child.
    Index detach(Index node);

    /// Puts a node that was taken out, with its parent, beside another node that is not the root.
    void attach(Index node, Index beside);

    /// Returns the whole tree with the moves made here.
    BvhTree whole() const;

  private:
    void replace_child(Index parent, Index old_child, Index new_child);
    void update_upward(Index node);

    const BvhTree& whole_;
    std::vector<Node> nodes_;  ///< the root first
};

/// Returns the smallest box that contains both.
inline Bounds united(Bounds a, const Bounds& b) {
    a.extend(b);
    return a;
}

}  // namespace etalon
