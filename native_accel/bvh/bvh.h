#pragma once

#include "core/intersect/intersector.h"
#include "native_accel/bvh/leaves.h"
#include "native_accel/bvh/wide_node.h"

namespace etalon {

/// A bounding volume hierarchy, built binary and walked four-wide.
class Bvh final : public Intersector {
  public:
    explicit Bvh(const Scene& scene);
    std::size_t memory_bytes() const override;

  protected:
    void closest_bounded(const RayQuery& query, const FrameRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const FrameRay& local) const override;

  private:
    std::vector<WideNode> nodes_;
    Leaves leaves_;
};

}  // namespace etalon
