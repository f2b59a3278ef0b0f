// Tracing of a ray through the clusters that Embree finds, compiled for several instruction sets.
// The best one that the machine has is used.
#pragma once

#include <array>

#include "core/accel/clusters/clusters.h"
#include "core/intersect/intersector.h"
#include "core/intersect/object_space.h"
#include "embree_backend/embree_shim.h"
#include "embree_backend/instance_trees.h"
#include "embree_backend/primitive_ids.h"

namespace etalon {

/// View of everything that a ray can hit.
struct UserView {
    RTCScene target;
    const Geometry& geometry;
    const Clusters& clusters;
    /// Items without a filter, in place of lists; the numbers after all items are those of instance
    /// trees.
    const PrimitiveIds& singles;
    const Intersector& instances;
    const ObjectSpace* objects;  ///< one for each object of the geometry
    const InstanceTrees& trees;
    const UserView* entered;  ///< views of the objects; null if only their intersectors know all
};

/// Callbacks and queries, which belong together: callbacks read the context that a query passes.
struct UserTracing {
    struct Callbacks {
        RTCIntersectFunctionN intersect;
        RTCOccludedFunctionN occluded;
    };

    std::array<Callbacks, 3> callbacks;  ///< for the geometries, by kind of cluster

    /// Offers `nearest` the kernels' hits at or before ray.ray.tfar, and keeps tfar at the nearest
    /// hit, rounded up.
    void (*intersect)(const UserView& view, const RayQuery& query, const NormalizedRay& local,
                      NearestHit& nearest, RTCRayHit& ray);

    /// Sets ray.tfar to a negative value if anything is hit.
    void (*occluded)(const UserView& view, const RayQuery& query, const NormalizedRay& local,
                     RTCRay& ray);
};

/// Returns the functions for the instruction set in use now.
UserTracing user_tracing();

}  // namespace etalon
