#pragma once

#include "core/intersect/intersector.h"
#include "native_accel/grid/box_pack.h"
#include "native_accel/grid/packed_grid.h"
#include "native_accel/grid/sphere_pack.h"
#include "native_accel/grid/triangle_pack.h"

namespace etalon {

/// Grids in grids, one for each kind of shape that has a filter of its own and one for the rest.
class Grid final : public Intersector {
  public:
    explicit Grid(const Scene& scene);
    std::size_t memory_bytes() const override;

  protected:
    void closest_bounded(const RayQuery& query, const FrameRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const FrameRay& local) const override;

  private:
    PackedGrid<SpherePack> spheres_;
    PackedGrid<TrianglePack> triangles_;
    PackedGrid<BoxPack> others_;
};

}  // namespace etalon
