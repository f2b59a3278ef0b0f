#include "core/accel/tree/linked_tree.h"

#include <algorithm>
#include <queue>

namespace etalon {
namespace {

Bounds bounds_of(const BvhNode& node) {
    const auto &low = node.box.min, &high = node.box.max;
    Bounds b;
    b.min = Bounds::Corner{low.x, low.y, low.z, 0};
    b.max = Bounds::Corner{high.x, high.y, high.z, 0};
    return b;
}

/// Returns the levels below each node. Children come after their parents.
std::vector<int> heights_of(const BvhTree& tree) {
    std::vector<int> heights(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const BvhNode& node = tree.nodes[i];
        if (i == 1 || node.is_leaf()) continue;
        heights[i] = 1 + std::max(heights[node.first], heights[node.first + 1]);
    }
    return heights;
}

/// Writes nodes in the order of BvhTree.
class TreeWriter {
  public:
    TreeWriter(const BvhTree& source, std::span<const LinkedTree::Node> top)
        : source_(source), top_(top) {
        tree_.nodes.reserve(source.nodes.size());
        tree_.nodes.resize(2);
        tree_.ids.reserve(source.ids.size());
        write_top(0, 0);
    }

    BvhTree take() { return std::move(tree_); }

  private:
    void write_top(LinkedTree::Index from, std::size_t to) {
        const LinkedTree::Node& node = top_[from];
        if (node.is_lowest()) return write_below(node.source, to);
        const std::size_t first = append_children(to, node.bounds.box());
        for (int i : {0, 1}) write_top(node.children[i], first + i);
    }

    void write_below(std::size_t from, std::size_t to) {
        const BvhNode& node = source_.nodes[from];
        if (!node.is_leaf()) {
            const std::size_t first = append_children(to, node.box);
            for (int i : {0, 1}) write_below(node.first + i, first + i);
            return;
        }
        tree_.nodes[to] = {node.box, static_cast<std::uint32_t>(tree_.ids.size()), node.count};
        const auto ids = source_.ids.begin() + node.first;
        tree_.ids.insert(tree_.ids.end(), ids, ids + node.count);
    }

    std::size_t append_children(std::size_t parent, const Box3f& box) {
        const std::size_t first = tree_.nodes.size();
        tree_.nodes[parent] = {box, static_cast<std::uint32_t>(first), 0};
        tree_.nodes.resize(first + 2);
        return first;
    }

    const BvhTree& source_;
    const std::span<const LinkedTree::Node> top_;
    BvhTree tree_;
};

}  // namespace

LinkedTree::LinkedTree(const BvhTree& whole, std::size_t most) : whole_(whole) {
    const std::vector<int> heights = heights_of(whole);
    using Sized = std::pair<float, Index>;
    std::priority_queue<Sized> largest;
    const auto add = [&](Index source, Index parent) {
        const BvhNode& node = whole.nodes[source];
        const auto index = static_cast<Index>(nodes_.size());
        nodes_.push_back({bounds_of(node), parent, {none, none}, source, heights[source]});
        if (!node.is_leaf()) largest.emplace(half_area(node.box), index);
        return index;
    };
    add(0, none);
    while (!largest.empty() && nodes_.size() + 2 <= most) {
        const Index parent = largest.top().second;
        largest.pop();
        const Index first = whole.nodes[nodes_[parent].source].first;
        for (Index i : {0, 1}) {
            const Index child = add(first + i, parent);
            nodes_[parent].children[i] = child;
        }
    }
}

double LinkedTree::surface() const {
    double sum = 0;
    for (const Node& node : nodes_) sum += node.is_lowest() ? 0 : node.bounds.half_area();
    return sum / nodes_.front().bounds.half_area();
}

float LinkedTree::growth(Index node, const Bounds& box) const {
    float sum = united(nodes_[node].bounds, box).half_area();
    for (Index i = nodes_[node].parent; i != none; i = nodes_[i].parent) {
        sum += united(nodes_[i].bounds, box).half_area() - nodes_[i].bounds.half_area();
    }
    return sum;
}

bool LinkedTree::may_attach(Index node, Index beside) const {
    int depth = 1 + std::max(nodes_[node].height, nodes_[beside].height);
    for (Index i = nodes_[beside].parent; i != none; i = nodes_[i].parent) ++depth;
    return depth <= bvh_max_depth;
}

LinkedTree::Index LinkedTree::detach(Index node) {
    const Index parent = nodes_[node].parent, above = nodes_[parent].parent;
    const auto& children = nodes_[parent].children;
    const Index sibling = children[children[0] == node ? 1 : 0];
    replace_child(above, parent, sibling);
    update_upward(above);
    return sibling;
}

void LinkedTree::attach(Index node, Index beside) {
    const Index parent = nodes_[node].parent;
    replace_child(nodes_[beside].parent, beside, parent);
    nodes_[parent].children = {beside, node};
    nodes_[beside].parent = parent;
    update_upward(parent);
}

void LinkedTree::replace_child(Index parent, Index old_child, Index new_child) {
    auto& children = nodes_[parent].children;
    children[children[0] == old_child ? 0 : 1] = new_child;
    nodes_[new_child].parent = parent;
}

void LinkedTree::update_upward(Index index) {
    for (; index != none; index = nodes_[index].parent) {
        Node& node = nodes_[index];
        const Node &left = nodes_[node.children[0]], &right = nodes_[node.children[1]];
        node.bounds = united(left.bounds, right.bounds);
        node.height = 1 + std::max(left.height, right.height);
    }
}

BvhTree LinkedTree::whole() const {
    return TreeWriter(whole_, nodes_).take();
}

}  // namespace etalon
