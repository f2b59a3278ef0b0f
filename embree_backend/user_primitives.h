#pragma once

#include <vector>

#include "core/intersect/bounded.h"
#include "embree_backend/device.h"
#include "embree_backend/user_tracing.h"

namespace etalon {

struct NestedSceneData;
class NestedScene;

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
    ~UserPrimitives();
    UserPrimitives(const UserPrimitives&) = delete;
    UserPrimitives& operator=(const UserPrimitives&) = delete;

    /// Number of geometry numbers that build() may use.
    static constexpr unsigned geometries = 3;

    /// Attaches `primitives`, in this normalized space, to `target` as geometries from the number
    /// `first` on, and builds `target` with whatever else is in it. `shared` is not null if they
    /// are in a nested scene already.
    void build(const EmbreeDevice& device, RTCScene target, unsigned first,
               const NormalizedSpace& space, std::vector<BoundedPrimitive> primitives,
               const std::shared_ptr<const NestedSceneData>& shared = nullptr);

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
    /// Puts a nested scene's box in the place of its instances.
    void make_nests(const EmbreeDevice& device, const NormalizedSpace& space,
                    std::shared_ptr<const NestedSceneData> shared,
                    std::vector<BoundedPrimitive>& singles);

    const Geometry& geometry_;
    const Intersector& instances_;
    const std::vector<UserView>* const entered_;
    bool empty_ = true;
    Clusters clusters_;
    PrimitiveIds singles_;
    std::vector<ObjectSpace> objects_;                        ///< empty in a nested scene
    std::shared_ptr<const NestedSceneData> made_for_nested_;  ///< null in a nested scene
    std::vector<std::unique_ptr<const NestedScene>> nested_scenes_;
    std::optional<UserView> view_;
    UserTracing tracing_ = user_tracing();
};

}  // namespace etalon
