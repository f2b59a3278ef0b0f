#pragma once

#include <vector>

#include "core/intersect/bounded.h"
#include "embree_backend/device.h"
#include "embree_backend/user_tracing.h"

namespace etalon {

/// Primitives of which Embree knows only the boxes: those of clusters, and of single primitives
/// that have no filter. Embree finds the boxes that a ray enters, nearest first; filters find what
/// the ray could hit in them, and the kernels decide. Its robust flag has no effect on these. A
/// float traversal loses no hit because the boxes are padded and tfar is never below the best t.
class UserPrimitives {
  public:
    /// `instances` answers queries for the geometry's instances. `objects`, if not null, has views
    /// of all that is bounded of each object when build() is called, for rays to enter them without
    /// their intersectors.
    UserPrimitives(const Geometry& geometry, const Intersector& instances,
                   const std::vector<UserView>* objects = nullptr);
    UserPrimitives(const UserPrimitives&) = delete;
    UserPrimitives& operator=(const UserPrimitives&) = delete;

    /// Number of geometries that build() may attach.
    static constexpr unsigned geometries = 3;

    /// Attaches `primitives`, in this normalized space, to `target` as its first geometries, and
    /// builds `target` with whatever else is in it.
    void build(const EmbreeDevice& device, RTCScene target, const NormalizedSpace& space,
               std::vector<BoundedPrimitive> primitives);

    bool empty() const { return empty_; }
    std::size_t memory_bytes() const;

    /// Returns what a ray can hit, once it is built.
    const UserView& view() const { return *view_; }

    /// Does the same as UserTracing::intersect.
    void intersect(const RayQuery& query, const NormalizedRay& local, NearestHit& nearest,
                   RTCRayHit& ray) const {
        tracing_.intersect(view(), query, local, nearest, ray);
    }
    void occluded(const RayQuery& query, const NormalizedRay& local, RTCRay& ray) const {
        tracing_.occluded(view(), query, local, ray);
    }

  private:
    const Geometry& geometry_;
    const Intersector& instances_;
    const std::vector<UserView>* const entered_;
    bool empty_ = true;
    Clusters clusters_;
    PrimitiveIds singles_;
    std::vector<ObjectSpace> objects_;
    InstanceTrees trees_;
    std::optional<UserView> view_;
    UserTracing tracing_ = user_tracing();
};

}  // namespace etalon
