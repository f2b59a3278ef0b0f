#include "native_accel/bvh/wide_node.h"

#include <algorithm>
#include <limits>

namespace etalon {
namespace {

float half_area(const Box3f& box) {
    const Vec3f s = box.size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

class Widener {
  public:
    Widener(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves,
            WideTree& tree)
        : nodes_(nodes), leaves_(leaves), tree_(tree) {}

    ChildRef place(const BvhNode& node) {
        if (node.is_leaf()) return ChildRef::leaf(leaves_[node.first]);
        tree_.nodes.emplace_back();
        fill(tree_.nodes.size() - 1, node);
        return ChildRef::node(0);
    }

  private:
    using List = std::vector<const BvhNode*>;

    void fill(std::size_t index, const BvhNode& source) {
        const List children = open(source);
        std::size_t next = tree_.nodes.size();
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

    /// Up to eight descendants that together stand for `root`, the largest first: the largest inner
    /// one is replaced by its two children as long as there is room.
    List open(const BvhNode& root) const {
        List list{&root};
        const auto openable_area = [](const BvhNode* n) {
            return n->is_leaf() ? -1 : half_area(n->box);
        };
        while (list.size() < node_width) {
            const auto largest = std::max_element(list.begin(), list.end(), [&](auto* a, auto* b) {
                return openable_area(a) < openable_area(b);
            });
            if ((*largest)->is_leaf()) break;
            const BvhNode* children = &nodes_[(*largest)->first];
            *largest = children;
            list.push_back(children + 1);
        }
        std::sort(list.begin(), list.end(),
                  [](auto* a, auto* b) { return half_area(a->box) > half_area(b->box); });
        return list;
    }

    const std::vector<BvhNode>& nodes_;
    const std::vector<ClusterRef>& leaves_;
    WideTree& tree_;
};

}  // namespace

WideNode::WideNode() {
    constexpr float far = std::numeric_limits<float>::infinity();
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        planes[plane].fill(plane % 2 == 0 ? far : -far);
    }
}

void WideNode::set(std::size_t lane, const Box3f& box, ChildRef child) {
    for (int k = 0; k < 3; ++k) {
        planes[2 * k][lane] = box.min[k];
        planes[2 * k + 1][lane] = box.max[k];
    }
    children[lane] = child;
}

WideTree widen(const std::vector<BvhNode>& nodes, const std::vector<ClusterRef>& leaves) {
    WideTree tree;
    tree.root = Widener(nodes, leaves, tree).place(nodes[0]);
    tree.nodes.shrink_to_fit();
    return tree;
}

}  // namespace etalon
