// A ray on its way through clusters that Embree found: compiled for several instruction sets, of
// which the best that the machine has is taken.
#pragma once

#include <array>

#include "core/accel/clusters/clusters.h"
#include "core/intersect/intersector.h"
#include "core/intersect/object_space.h"
#include "embree_backend/embree_shim.h"
#include "embree_backend/primitive_ids.h"

namespace etalon {

class Nest;

/// View of all that a ray can meet.
struct UserView {
    RTCScene target;
    const Geometry& geometry;
    const Clusters& clusters;
    /// Items that no filter is for, in place of lists; the numbers after all items are nests'.
    const PrimitiveIds& singles;
    const Intersector& instances;
    const ObjectSpace* objects;  ///< one for each object of the geometry
    const std::unique_ptr<const Nest>* nests;
};

/// Callbacks and queries, which belong together: callbacks read the context that a query passes.
struct UserTracing {
    struct Callbacks {
        RTCIntersectFunctionN intersect;
        RTCOccludedFunctionN occluded;
    };

    std::array<Callbacks, 3> callbacks;  ///< of the geometries, by kind of cluster

    /// Offers `nearest` what the kernels hit no later than at ray.ray.tfar, and keeps that at the
    /// nearest hit, rounded up.
    void (*intersect)(const UserView& view, const RayQuery& query, const NormalizedRay& local,
                      NearestHit& nearest, RTCRayHit& ray);

    /// Leaves a negative ray.tfar where anything is hit.
    void (*occluded)(const UserView& view, const RayQuery& query, const NormalizedRay& local,
                     RTCRay& ray);
};

/// Returns the functions for the instruction set in use now.
UserTracing user_tracing();

}  // namespace etalon
