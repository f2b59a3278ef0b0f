#include "native_accel/grid/grid_trace.h"

#include <algorithm>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/grid/grid_trace.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "native_accel/grid/grid_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void trace_closest(const GridView& grid, const RayQuery& query, const NormalizedRay& local,
                   NearestHit& nearest) {
    find_closest(grid, query, local, nearest, Uncounted());
}

bool trace_occluded(const GridView& grid, const RayQuery& query, const NormalizedRay& local) {
    constexpr float nowhere = -std::numeric_limits<float>::infinity();
    float tmax = local.tmax(query.ray.tmax);
    bool found = false;
    const auto offer = [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.ray.tmax;
        if (found) tmax = nowhere;
        return tmax;
    };
    const auto offer_cluster = [&](ClusterRef ref) HWY_ATTR {
        found = instances_occlude(grid.instances, grid.others.clusters(), ref, query);
        if (found) tmax = nowhere;
        return tmax;
    };
    trace(grid, query, local, tmax, Uncounted(), offer, offer_cluster);
    return found;
}

GridTrace grid_trace() {
    return {trace_closest, trace_occluded};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(grid_trace);

GridTrace grid_trace() {
    return HWY_DYNAMIC_DISPATCH(grid_trace)();
}

}  // namespace etalon
#endif
