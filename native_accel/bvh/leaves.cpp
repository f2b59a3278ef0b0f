#include "native_accel/bvh/leaves.h"

#include <algorithm>
#include <span>

namespace etalon {
namespace {

using Ids = std::span<const std::uint32_t>;

bool all_triangles(const Scene& scene, Ids ids) {
    return std::all_of(ids.begin(), ids.end(), [&](std::uint32_t id) {
        return scene.primitives[id].kind == kind_of<Triangle>();
    });
}

void pack(const Scene& scene, const Frame& frame, Ids ids, std::vector<TriangleLeaf>& leaves) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::size_t lane = i % TriangleLeaf::lanes;
        if (lane == 0) leaves.emplace_back();
        leaves.back().set(lane, scene, frame, ids[i]);
    }
}

}  // namespace

Leaves::Leaves(const Scene& scene, const Frame& frame, BvhTree& tree) {
    for (BvhNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        const Ids ids = Ids(tree.ids).subspan(node.first, node.count);
        if (all_triangles(scene, ids)) {
            node.first = static_cast<std::uint32_t>(triangles_.size());
            pack(scene, frame, ids, triangles_);
            node.count = packed | static_cast<std::uint32_t>(triangles_.size() - node.first);
        } else {
            node.first = static_cast<std::uint32_t>(ids_.size());
            ids_.insert(ids_.end(), ids.begin(), ids.end());
        }
    }
    triangles_.shrink_to_fit();
    ids_.shrink_to_fit();
}

std::size_t Leaves::memory_bytes() const {
    return triangles_.capacity() * sizeof(TriangleLeaf) + ids_.capacity() * sizeof(std::uint32_t);
}

}  // namespace etalon
