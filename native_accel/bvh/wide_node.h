#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/intersect/clusters/clusters.h"
#include "core/intersect/tree/node.h"

namespace etalon {

/// What a child of a wide node is: another node, by its index, or a cluster of primitives.
class ChildRef {
  public:
    static ChildRef node(std::size_t index) { return ChildRef(static_cast<std::uint32_t>(index)); }
    static ChildRef leaf(ClusterRef cluster) { return ChildRef(leaf_bit | cluster.bits); }
    explicit ChildRef(std::uint32_t from) : bits_(from) {}
    ChildRef() = default;

    bool is_leaf() const { return (bits_ & leaf_bit) != 0; }
    std::uint32_t node() const { return bits_; }
    ClusterRef cluster() const { return ClusterRef(bits_ & ~leaf_bit); }
    std::uint32_t bits() const { return bits_; }

  private:
    static constexpr std::uint32_t leaf_bit = 0x80000000U;

    std::uint32_t bits_ = 0;
};

inline constexpr std::size_t node_width = 8;

/// Eight children and their boxes in the frame, padded. Lanes without a child hold a box that
/// nothing enters.
struct alignas(64) WideNode {
    /// Sets nothing, so that many are first written by the threads that fill them.
    WideNode() {}

    /// Takes all children out.
    void clear();
    void set(std::size_t lane, const Box3f& box, ChildRef child);

    /// How many children it has.
    std::size_t count() const;

    /// Where in `planes` the lanes of an axis's min or max begin: min x, max x, min y, ...
    static constexpr std::size_t plane(int axis, bool max) {
        return (2 * axis + (max ? 1 : 0)) * node_width;
    }

    std::array<float, 6 * node_width> planes;
    std::array<ChildRef, node_width> children;
};

static_assert(sizeof(WideNode) == 256);

/// Nodes in depth-first order but for siblings, which are together; and where to begin.
struct WideTree {
    bool empty() const { return nodes.empty() && !root.is_leaf(); }

    std::vector<WideNode, LargePages<WideNode>> nodes;
    ChildRef root;
    /// How many nodes a random line through the root's box enters, by their surfaces.
    double expected_nodes = 1;
};

/// Places a binary tree's nodes up to eight to one. A binary leaf's `first` says which of `leaves`
/// it becomes. The tree, in the order of BvhTree, must not be empty. On as many threads as allowed.
WideTree widen(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves);

}  // namespace etalon
