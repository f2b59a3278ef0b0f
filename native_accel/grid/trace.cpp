#include "native_accel/grid/trace.h"

#include <algorithm>

#include "core/intersect/clusters/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/grid/trace.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "native_accel/grid/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void trace_closest(const GridView& grid, const RayQuery& query, const FrameRay& local,
                   NearestHit& nearest) {
    find_closest(grid, query, local, nearest, Uncounted());
}

bool trace_occluded(const GridView& grid, const RayQuery& query, const FrameRay& local) {
    constexpr float nowhere = -std::numeric_limits<float>::infinity();
    float tmax = local.tmax(query.ray.tmax);
    bool found = false;
    trace(grid, query, local, tmax, Uncounted(), [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.ray.tmax;
        if (found) tmax = nowhere;
        return tmax;
    });
    return found;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(trace_closest);
HWY_EXPORT(trace_occluded);

void trace_closest(const GridView& grid, const RayQuery& query, const FrameRay& local,
                   NearestHit& nearest) {
    HWY_DYNAMIC_DISPATCH(trace_closest)(grid, query, local, nearest);
}

bool trace_occluded(const GridView& grid, const RayQuery& query, const FrameRay& local) {
    return HWY_DYNAMIC_DISPATCH(trace_occluded)(grid, query, local);
}

}  // namespace etalon
#endif
