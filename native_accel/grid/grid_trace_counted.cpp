// A file of its own, so that it does not affect how the code without counters is compiled.
#include <algorithm>

#include "core/numerics/instruction_sets.h"
#include "native_accel/grid/grid_trace.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/grid/grid_trace_counted.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "native_accel/grid/grid_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void trace_closest_counted(const GridView& grid, const RayQuery& query, const NormalizedRay& local,
                           NearestHit& nearest, TraversalCost& cost) {
    find_closest(grid, query, local, nearest, Counted{cost});
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(trace_closest_counted);

void trace_closest_counted(const GridView& grid, const RayQuery& query, const NormalizedRay& local,
                           NearestHit& nearest, TraversalCost& cost) {
    HWY_DYNAMIC_DISPATCH(trace_closest_counted)(grid, query, local, nearest, cost);
}

}  // namespace etalon
#endif
