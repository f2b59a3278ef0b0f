#include "native_accel/bvh/bvh.h"

#include "native_accel/bvh/builder.h"
#include "native_accel/bvh/walk.h"

namespace etalon {
namespace {

/// Where most primitives have a filter, leaves of as many as pays when eight cost as much as one.
BvhConfig config_for(const Scene& scene) {
    BvhConfig config;
    const std::size_t filtered = scene.all<Triangle>().size() + scene.all<Sphere>().size();
    if (2 * filtered < scene.primitives.size()) return config;
    config.lanes = cluster_lanes;
    return config;
}

/// Numbers the leaves, in their `first`, and returns which primitives each one has.
std::vector<Range> number_leaves(BvhTree& tree) {
    std::vector<Range> ranges;
    for (BvhNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        ranges.push_back({node.first, node.count});
        node.first = static_cast<std::uint32_t>(ranges.size() - 1);
    }
    return ranges;
}

}  // namespace

Bvh::Bvh(const Scene& scene) : Intersector(scene) {
    BvhTree tree = build_bvh(take_bounded(), config_for(scene));
    if (tree.nodes.empty()) return;
    const std::vector<Range> ranges = number_leaves(tree);
    std::vector<ClusterRef> refs;
    clusters_ = Clusters(scene, scene_bounds().frame, tree.ids, ranges, refs);
    tree_ = widen(tree.nodes, refs);
}

std::size_t Bvh::memory_bytes() const {
    return tree_.nodes.capacity() * sizeof(WideNode) + clusters_.memory_bytes();
}

std::string Bvh::isa() const {
    return walk_isa();
}

void Bvh::closest_bounded(const RayQuery& query, const FrameRay& local, NearestHit& nearest) const {
    if (!tree_.empty()) walk_closest({scene(), tree_, clusters_}, query, local, nearest);
}

bool Bvh::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    return !tree_.empty() && walk_occluded({scene(), tree_, clusters_}, query, local);
}

}  // namespace etalon
