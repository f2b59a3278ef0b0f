#pragma once

#include "core/intersect/intersector.h"
#include "native_accel/grid/cells.h"

namespace etalon {

class Grid final : public Intersector {
  public:
    explicit Grid(const Scene& scene);
    std::size_t memory_bytes() const override;

  protected:
    void closest_bounded(const RayQuery& query, const FrameRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const FrameRay& local) const override;

  private:
    GridCells cells_;
};

}  // namespace etalon
