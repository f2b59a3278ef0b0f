#pragma once

#include <vector>

#include "core/intersect/bounded.h"
#include "embree_backend/device.h"
#include "embree_backend/user_tracing.h"

namespace etalon {

struct FineBoxes;
class Nest;

/// Primitives of which Embree knows only the boxes: those of clusters, and of single primitives
/// where there is no filter for a cluster. It finds the boxes that a ray meets, nearest first;
/// filters say what in them the ray could hit, and the kernels decide. Its robust flag does nothing
/// for these: that a float traversal loses no hit is due to the padding of the boxes and to a tfar
/// that is never below the best t.
class UserPrimitives {
  public:
    /// `instances` answers for the geometry's instances.
    UserPrimitives(const Geometry& geometry, const Intersector& instances);
    ~UserPrimitives();
    UserPrimitives(const UserPrimitives&) = delete;
    UserPrimitives& operator=(const UserPrimitives&) = delete;

    /// How many numbers of geometries build() may use.
    static constexpr unsigned geometries = 3;

    /// Puts `primitives`, of this frame, into `target` as geometries from the number `first` on,
    /// and builds it with whatever else is in it. `fine`: if they are in a nest already.
    void build(const EmbreeDevice& device, RTCScene target, unsigned first,
               const NormalizedSpace& space, std::vector<BoundedPrimitive> primitives,
               std::shared_ptr<const FineBoxes> fine = nullptr);

    bool empty() const { return empty_; }
    std::size_t memory_bytes() const;

    /// Does what UserTracing::intersect does.
    void intersect(RTCScene target, const RayQuery& query, const NormalizedRay& local,
                   NearestHit& nearest, RTCRayHit& ray) const {
        tracing_.intersect(view(target), query, local, nearest, ray);
    }
    void occluded(RTCScene target, const RayQuery& query, const NormalizedRay& local,
                  RTCRay& ray) const {
        tracing_.occluded(view(target), query, local, ray);
    }

  private:
    UserView view(RTCScene target) const {
        return {target, geometry_, clusters_, singles_, instances_, objects_.data(), nests_.data()};
    }

    /// Puts a nest's box in the place of its instances.
    void make_nests(const EmbreeDevice& device, const NormalizedSpace& space,
                    std::shared_ptr<const FineBoxes> fine, std::vector<BoundedPrimitive>& singles);

    const Geometry& geometry_;
    const Intersector& instances_;
    bool empty_ = true;
    Clusters clusters_;
    PrimitiveIds singles_;
    std::vector<ObjectSpace> objects_;
    std::vector<std::unique_ptr<const Nest>> nests_;
    UserTracing tracing_ = user_tracing();
};

}  // namespace etalon
