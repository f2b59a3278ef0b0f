#include "native_accel/bvh/wide_node.h"

#include <algorithm>
#include <limits>

namespace etalon {
namespace {

constexpr std::size_t lanes = 4;

float half_area(const Box3f& box) {
    const Vec3f s = box.size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// Up to four descendants that together stand for `root`: the largest inner one is replaced by its
/// two children as long as there is room.
std::vector<const BvhNode*> open(const std::vector<BvhNode>& nodes, const BvhNode& root) {
    std::vector<const BvhNode*> list{&root};
    const auto openable_area = [](const BvhNode* n) {
        return n->is_leaf() ? -1 : half_area(n->box);
    };
    while (list.size() < lanes) {
        const auto largest = std::max_element(list.begin(), list.end(), [&](auto* a, auto* b) {
            return openable_area(a) < openable_area(b);
        });
        if ((*largest)->is_leaf()) break;
        const BvhNode* children = &nodes[(*largest)->first];
        *largest = children;
        list.push_back(children + 1);
    }
    return list;
}

/// Boxes that no ray enters: the near planes lie behind the far ones.
WideNode without_children() {
    constexpr float far = std::numeric_limits<float>::infinity();
    WideNode node{};
    for (int k = 0; k < 3; ++k) {
        node.planes[k] = broadcast(far);
        node.planes[3 + k] = broadcast(-far);
    }
    return node;
}

}  // namespace

std::vector<WideNode> widen(const std::vector<BvhNode>& nodes) {
    std::vector<WideNode> result;
    if (nodes.empty()) return result;
    std::vector<const BvhNode*> sources{&nodes[0]};  // sources[i] becomes result[i]
    for (std::size_t i = 0; i < sources.size(); ++i) {
        WideNode wide = without_children();
        const std::vector<const BvhNode*> children = open(nodes, *sources[i]);
        for (std::size_t lane = 0; lane < children.size(); ++lane) {
            const BvhNode& child = *children[lane];
            for (int k = 0; k < 3; ++k) {
                wide.planes[k][lane] = child.box.min[k];
                wide.planes[3 + k][lane] = child.box.max[k];
            }
            wide.count[lane] = child.count;
            wide.first[lane] =
                child.is_leaf() ? child.first : static_cast<std::uint32_t>(sources.size());
            if (!child.is_leaf()) sources.push_back(&child);
        }
        result.push_back(wide);
    }
    result.shrink_to_fit();
    return result;
}

}  // namespace etalon
