#pragma once

#include "core/intersect/intersector.h"
#include "native_accel/grid/grid_trace.h"

namespace etalon {

/// Nested grids: one whose cells hold spheres, and one over clusters of all other primitives.
class Grid final : public Intersector {
  public:
    explicit Grid(const Geometry& geometry);
    std::string isa() const override;

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    void closest_counted(const RayQuery& query, const NormalizedRay& local, NearestHit& nearest,
                         TraversalCost& cost) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    GridView view() const { return {geometry(), spheres_, others_, *this}; }

    PackedGrid<SpherePack> spheres_;
    ClusterGrid others_;
    const GridTrace trace_ = grid_trace();
};

}  // namespace etalon
