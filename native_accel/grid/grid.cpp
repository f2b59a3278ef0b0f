#include "native_accel/grid/grid.h"

#include "core/intersect/kernels.h"
#include "native_accel/grid/walk.h"

namespace etalon {

Grid::Grid(const Scene& scene) : Intersector(scene) {
    cells_ = GridCells(take_bounded(), {});
}

std::size_t Grid::memory_bytes() const {
    return (cells_.offsets.capacity() + cells_.ids.capacity()) * sizeof(std::uint32_t);
}

void Grid::closest_bounded(const RayQuery& query, const FrameRay& local,
                           NearestHit& nearest) const {
    if (cells_.ids.empty()) return;
    GridWalk walk(cells_.shape, cells_.box, local, local.tmin(query.ray.tmin),
                  local.tmax(nearest.t));
    for (; walk.inside(); walk.advance()) {
        for (const std::uint32_t id : cells_.in(walk.cell())) {
            nearest.offer(primitive_first_hit(scene(), id, query), id);
        }
        // What is hit further on lies beyond this cell; at the very border both cells must be seen.
        if (local.tmax(nearest.t) < walk.exit()) return;
    }
}

bool Grid::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    if (cells_.ids.empty()) return false;
    const float tmax = local.tmax(query.ray.tmax);
    GridWalk walk(cells_.shape, cells_.box, local, local.tmin(query.ray.tmin), tmax);
    for (; walk.inside(); walk.advance()) {
        for (const std::uint32_t id : cells_.in(walk.cell())) {
            if (primitive_first_hit(scene(), id, query) <= query.ray.tmax) return true;
        }
        if (tmax < walk.exit()) return false;
    }
    return false;
}

}  // namespace etalon
