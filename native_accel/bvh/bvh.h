#pragma once

#include "core/intersect/intersector.h"
#include "native_accel/bvh/builder.h"

namespace etalon {

class Bvh final : public Intersector {
  public:
    explicit Bvh(const Scene& scene);
    std::size_t memory_bytes() const override;

  protected:
    void closest_bounded(const RayQuery& query, const FrameRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const FrameRay& local) const override;

  private:
    BvhTree tree_;
};

}  // namespace etalon
