// Traversal of the grids by a ray, compiled for several instruction sets. The best one that the
// machine has is used.
#pragma once

#include "core/intersect/intersector.h"
#include "core/intersect/ray.h"
#include "core/intersect/traversal_cost.h"
#include "native_accel/grid/cluster_grid.h"
#include "native_accel/grid/sphere_pack.h"

namespace etalon {

/// View of the data that tracing a ray needs.
struct GridView {
    const Geometry& geometry;
    const PackedGrid<SpherePack>& spheres;
    const ClusterGrid& others;
    const Intersector& instances;
};

/// Tracing functions for one instruction set.
struct GridTrace {
    /// Offers `nearest` every primitive that could be hit no later than nearest.t.
    void (*closest)(const GridView& grid, const RayQuery& query, const NormalizedRay& local,
                    NearestHit& nearest);

    /// Returns whether any primitive is hit at t <= query.ray.tmax.
    bool (*occluded)(const GridView& grid, const RayQuery& query, const NormalizedRay& local);
};

/// Returns the functions for the instruction set in use now.
GridTrace grid_trace();

/// Finds the hit as GridTrace::closest does. Adds to `cost` the cells, the boxes in them, and the
/// members of all clusters that are tested.
void trace_closest_counted(const GridView& grid, const RayQuery& query, const NormalizedRay& local,
                           NearestHit& nearest, TraversalCost& cost);

}  // namespace etalon
