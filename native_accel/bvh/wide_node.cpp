#include "native_accel/bvh/wide_node.h"

#include <algorithm>
#include <limits>

#include "native_accel/bvh/collapse.h"

namespace etalon {
namespace {

class Widener {
  public:
    Widener(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves,
            WideTree& tree)
        : collapse_(nodes), leaves_(leaves), tree_(tree) {}

    ChildRef place(const BvhNode& root) {
        if (root.is_leaf()) return ChildRef::leaf(leaves_[root.first]);
        tree_.nodes.emplace_back();
        fill(0, root);
        tree_.expected_nodes = surface_ / half_area(root.box);
        return ChildRef::node(0);
    }

  private:
    using List = std::vector<const BvhNode*>;

    void fill(std::size_t index, const BvhNode& source) {
        const List children = open(source);
        std::size_t next = tree_.nodes.size();
        surface_ += half_area(source.box);
        for (std::size_t lane = 0; lane < children.size(); ++lane) {
            const BvhNode& child = *children[lane];
            const ChildRef ref =
                child.is_leaf() ? ChildRef::leaf(leaves_[child.first]) : ChildRef::node(next++);
            tree_.nodes[index].set(lane, child.box, ref);
        }
        std::size_t first = tree_.nodes.size();
        tree_.nodes.resize(next);
        for (const BvhNode* child : children) {
            if (!child->is_leaf()) fill(first++, *child);
        }
    }

    /// The largest first: occlusion takes them as they come.
    List open(const BvhNode& source) const {
        List list = collapse_.children(source);
        std::sort(list.begin(), list.end(),
                  [](auto* a, auto* b) { return half_area(a->box) > half_area(b->box); });
        return list;
    }

    const Collapse collapse_;
    const std::vector<ClusterRef>& leaves_;
    WideTree& tree_;
    double surface_ = 0;
};

}  // namespace

WideNode::WideNode() {
    constexpr float far = std::numeric_limits<float>::infinity();
    for (std::size_t lane = 0; lane < node_width; ++lane) {
        set(lane, Box3f(Vec3f(far), Vec3f(-far)), ChildRef());
    }
}

void WideNode::set(std::size_t lane, const Box3f& box, ChildRef child) {
    for (int k = 0; k < 3; ++k) {
        planes[plane(k, false) + lane] = box.min[k];
        planes[plane(k, true) + lane] = box.max[k];
    }
    children[lane] = child;
}

std::size_t WideNode::count() const {
    const float* low = &planes[plane(0, false)];
    const float* high = &planes[plane(0, true)];
    std::size_t lane = 0;
    while (lane < node_width && low[lane] <= high[lane]) ++lane;
    return lane;
}

WideTree widen(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves) {
    WideTree tree;
    tree.root = Widener(nodes, leaves, tree).place(nodes[0]);
    tree.nodes.shrink_to_fit();
    return tree;
}

}  // namespace etalon
