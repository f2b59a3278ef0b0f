#include "core/accel/clusters/instance_list.h"

namespace etalon {

void offer_instances(const Intersector& intersector, const Clusters& clusters, ClusterRef ref,
                     const RayQuery& query, NearestHit& nearest, TraversalCost* cost) {
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        const std::uint32_t item = clusters.item(ref, lane);
        if (item == no_index) return;
        intersector.offer_instance(item, query, nearest, cost);
    }
}

bool instances_occlude(const Intersector& intersector, const Clusters& clusters, ClusterRef ref,
                       const RayQuery& query) {
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        const std::uint32_t item = clusters.item(ref, lane);
        if (item == no_index) return false;
        if (intersector.instance_occludes(item, query)) return true;
    }
    return false;
}

}  // namespace etalon
