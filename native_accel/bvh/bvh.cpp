#include "native_accel/bvh/bvh.h"

#include "core/accel/tree/reinsertion.h"
#include "core/accel/tree/scene_tree.h"
#include "native_accel/common/isa.h"

namespace etalon {
namespace {

const InstancePadding& padding_for(const Geometry& geometry) {
    return geometry.instances.empty() ? full_padding : least_padding;
}

}  // namespace

Bvh::Bvh(const Geometry& geometry)
    : Intersector(geometry, SceneBounds::of(geometry, padding_for(geometry))),
      traversal_(geometry.instances.empty() ? bvh_traversal() : bvh_instance_traversal()) {
    build_objects<Bvh>();
    for (std::uint32_t i = 0; i < geometry.objects.size(); ++i) {
        entries_.emplace_back(static_cast<const Bvh&>(object(i)).view());
    }
    BvhTree tree = build_scene_bvh(geometry, scene_bounds().space, take_bounded());
    if (!geometry.instances.empty()) tree = reinserted(std::move(tree));
    if (tree.nodes.empty()) return;
    const std::vector<Range> ranges = number_leaves(tree);
    const std::vector<ClusterRef> refs = cluster_refs(geometry, tree.ids, ranges);
    tree_ = widen(tree.nodes, refs);
    std::vector<BvhNode>().swap(tree.nodes);  // before building the clusters, which take the most
    clusters_ = Clusters(geometry, scene_bounds().space, tree.ids, ranges, refs);
}

std::size_t Bvh::own_bytes() const {
    return tree_.nodes.capacity() * sizeof(WideNode) + clusters_.memory_bytes() +
           entries_.capacity() * sizeof(BvhObject);
}

std::string Bvh::isa() const {
    return traversal_isa();
}

void Bvh::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                          NearestHit& nearest) const {
    if (!tree_.empty()) traversal_.closest(view(), query, local, nearest);
}

void Bvh::closest_counted(const RayQuery& query, const NormalizedRay& local, NearestHit& nearest,
                          TraversalCost& cost) const {
    if (!tree_.empty()) traversal_.closest_counted(view(), query, local, nearest, cost);
}

bool Bvh::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    return !tree_.empty() && traversal_.occluded(view(), query, local);
}

}  // namespace etalon
