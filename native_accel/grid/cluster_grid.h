#pragma once

#include "core/intersect/bounded.h"
#include "native_accel/grid/box_pack.h"
#include "native_accel/grid/packed_grid.h"

namespace etalon {

/// A grid over clusters. Each cluster is stored once, however many cells list its box. A cell with
/// a hundred triangles costs about as much as one with a few, so that cells can be large.
class ClusterGrid {
  public:
    ClusterGrid() = default;

    /// Makes clusters of the leaves of the hierarchy that `bvh` uses: these are as compact as
    /// possible, and of pieces of triangles where that pays.
    ClusterGrid(const Geometry& geometry, const NormalizedSpace& space,
                std::vector<BoundedPrimitive> primitives);

    const PackedGrid<BoxPack>& boxes() const { return boxes_; }
    const Clusters& clusters() const { return clusters_; }

    std::size_t memory_bytes() const { return boxes_.memory_bytes() + clusters_.memory_bytes(); }

  private:
    PackedGrid<BoxPack> boxes_;
    Clusters clusters_;
};

}  // namespace etalon
