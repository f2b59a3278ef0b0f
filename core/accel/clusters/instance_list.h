#pragma once

#include "core/accel/clusters/clusters.h"
#include "core/intersect/intersector.h"

namespace etalon {

/// Offers `nearest` the instances of a cluster. Adds to `cost` if it is not null.
void offer_instances(const Intersector& intersector, const Clusters& clusters, ClusterRef ref,
                     const RayQuery& query, NearestHit& nearest, TraversalCost* cost);

/// Returns whether an instance of a cluster is hit with t <= query.ray.tmax.
bool instances_occlude(const Intersector& intersector, const Clusters& clusters, ClusterRef ref,
                       const RayQuery& query);

}  // namespace etalon
