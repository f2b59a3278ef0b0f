#include "native_accel/bvh/traversal.h"

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/bvh/traversal.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "native_accel/bvh/queries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace {

void traverse_closest(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                      NearestHit& nearest) {
    const float tmin = local.tmin(query.ray.tmin);
    const Slabs boxes(local, tmin);
    if (bvh.predicts_branches(query.ray)) {
        find_closest<BranchingLaneSelect>(bvh, query, local, tmin, boxes, nearest, Uncounted());
    } else {
        find_closest<BranchlessLaneSelect>(bvh, query, local, tmin, boxes, nearest, Uncounted());
    }
}

void traverse_closest_counted(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                              NearestHit& nearest, TraversalCost& cost) {
    const float tmin = local.tmin(query.ray.tmin);
    const Slabs boxes(local, tmin);
    find_closest<BranchlessLaneSelect>(bvh, query, local, tmin, boxes, nearest, Counted{cost});
}

bool traverse_occluded(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local) {
    const float tmin = local.tmin(query.ray.tmin);
    const Slabs boxes(local, tmin);
    return bvh.predicts_branches(query.ray)
               ? find_any<BranchingLaneSelect>(bvh, query, local, tmin, boxes)
               : find_any<BranchlessLaneSelect>(bvh, query, local, tmin, boxes);
}

}  // namespace

BvhTraversal bvh_traversal() {
    return {traverse_closest, traverse_closest_counted, traverse_occluded};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(bvh_traversal);

BvhTraversal bvh_traversal() {
    return HWY_DYNAMIC_DISPATCH(bvh_traversal)();
}

}  // namespace etalon
#endif
