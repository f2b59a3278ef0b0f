#include "core/accel/clusters/instance_list.h"

namespace etalon {

void offer_instances(const Intersector& intersector, const Clusters& clusters, ClusterRef ref,
                     const RayQuery& query, NearestHit& nearest, TraversalCost* cost) {
    clusters.visit_instances(ref, [&](std::uint32_t item) {
        intersector.offer_instance(item, query, nearest, cost);
        return true;
    });
}

bool instances_occlude(const Intersector& intersector, const Clusters& clusters, ClusterRef ref,
                       const RayQuery& query) {
    bool found = false;
    clusters.visit_instances(ref, [&](std::uint32_t item) {
        found = intersector.instance_occludes(item, query);
        return !found;
    });
    return found;
}

}  // namespace etalon
