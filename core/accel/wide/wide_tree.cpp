#include "core/accel/wide/wide_tree.h"

#include <algorithm>
#include <numeric>

#include "core/accel/wide/collapse.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// Counts the nodes below each node before it writes them, so that all know their indices.
class Widener {
  public:
    Widener(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves,
            WideTree& tree)
        : first_(nodes.data()),
          collapse_(nodes),
          leaves_(leaves),
          tree_(tree),
          below_(std::make_unique_for_overwrite<std::uint32_t[]>(nodes.size())) {}

    ChildRef place() {
        const Branch root = collapse_.root();
        if (root.is_leaf()) return ChildRef::leaf(leaves_[root.node->first]);
        tree_.nodes.resize(1 + count(root));
        fill(0, root, 1);
        tree_.expected_nodes = collapse_.surface() / half_area(root.node->box);
        return ChildRef::node(0);
    }

  private:
    /// Calls f for each child, in parallel if the branch is large.
    template <class F>
    static void for_each(const Branch& parent, std::size_t children, const F& f) {
        constexpr std::size_t serial_up_to = 1024;
        const auto some = [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) f(i);
        };
        parent.size() > serial_up_to ? parallel_for(children, 1, some) : some(0, children);
    }

    std::uint32_t& below(const Branch& branch) { return below_[branch.node - first_]; }

    /// Returns the number of nodes below one.
    std::uint32_t count(const Branch& source) {
        const Branches children = collapse_.children(source);
        std::array<std::uint32_t, node_width> of_child{};
        for_each(source, children.count, [&](std::size_t i) {
            const Branch& child = children.all[i];
            if (!child.is_leaf()) of_child[i] = 1 + count(child);
        });
        return below(source) = std::accumulate(of_child.begin(), of_child.end(), 0U);
    }

    /// Fills a node. Its children are stored from index `free` on.
    void fill(std::size_t index, const Branch& source, std::size_t free) {
        const Branches children = open(source);
        WideNode& node = tree_.nodes[index];
        node.clear();
        std::array<std::size_t, node_width> place{}, next{};
        for (std::size_t lane = 0; lane < children.count; ++lane) {
            const Branch& child = children.all[lane];
            if (!child.is_leaf()) place[lane] = free++;
            node.set(lane, child.node->box,
                     child.is_leaf() ? ChildRef::leaf(leaves_[child.node->first])
                                     : ChildRef::node(place[lane]));
        }
        for (std::size_t lane = 0; lane < children.count; ++lane) {
            next[lane] = free;
            if (!children.all[lane].is_leaf()) free += below(children.all[lane]);
        }
        for_each(source, children.count, [&](std::size_t lane) {
            const Branch& child = children.all[lane];
            if (!child.is_leaf()) fill(place[lane], child, next[lane]);
        });
    }

    /// Returns the children, the largest first, since occlusion queries take them in that order.
    Branches open(const Branch& source) const {
        Branches list = collapse_.children(source);
        const auto is_larger = [](const Branch& a, const Branch& b) {
            return half_area(a.node->box) > half_area(b.node->box);
        };
        // Insertion: GCC 14 warns of the part of std::sort that is for longer lists.
        for (Branch* next = list.begin(); next != list.end(); ++next) {
            std::rotate(std::upper_bound(list.begin(), next, *next, is_larger), next, next + 1);
        }
        return list;
    }

    const BvhNode* const first_;
    const Collapse collapse_;
    const std::vector<ClusterRef>& leaves_;
    WideTree& tree_;
    std::unique_ptr<std::uint32_t[]> below_;  ///< number of nodes below each node that remains
};

}  // namespace

std::vector<Range> number_leaves(BvhTree& tree) {
    std::vector<Range> ranges;
    for (BvhNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        ranges.push_back({node.first, node.count});
        node.first = static_cast<std::uint32_t>(ranges.size() - 1);
    }
    return ranges;
}

WideTree widen(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves) {
    WideTree tree;
    tree.root = Widener(nodes, leaves, tree).place();
    return tree;
}

}  // namespace etalon
