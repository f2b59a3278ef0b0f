#pragma once

#include "core/intersect/intersector.h"
#include "native_accel/bvh/traversal.h"

namespace etalon {

/// A bounding volume hierarchy, built binary and traversed eight-wide, with clusters as leaves.
class Bvh final : public Intersector {
  public:
    explicit Bvh(const Geometry& geometry);
    std::string isa() const override;

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    void closest_counted(const RayQuery& query, const NormalizedRay& local, NearestHit& nearest,
                         TraversalCost& cost) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    BvhView view() const {
        return {geometry(), scene_bounds(), tree_, clusters_, *this, entries_.data()};
    }

    std::vector<BvhObject> entries_;  ///< of the objects
    WideTree tree_;
    Clusters clusters_;
    const BvhTraversal traversal_;
};

}  // namespace etalon
