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
    const auto same = [&]() HWY_ATTR -> const RayQuery& { return query; };
    const AnyInstances instances(bvh);
    if (bvh.predicts_branches(query.ray)) {
        find_closest<BranchingLaneSelect>(bvh, same, local, tmin, boxes, instances, nearest,
                                          Uncounted());
    } else {
        find_closest<BranchlessLaneSelect>(bvh, same, local, tmin, boxes, instances, nearest,
                                           Uncounted());
    }
}

void traverse_closest_counted(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                              NearestHit& nearest, TraversalCost& cost) {
    const float tmin = local.tmin(query.ray.tmin);
    const Slabs boxes(local, tmin);
    const auto same = [&]() HWY_ATTR -> const RayQuery& { return query; };
    find_closest<BranchlessLaneSelect>(bvh, same, local, tmin, boxes, AnyInstances(bvh), nearest,
                                       Counted{cost});
}

bool traverse_occluded(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local) {
    const float tmin = local.tmin(query.ray.tmin);
    const Slabs boxes(local, tmin);
    const auto same = [&]() HWY_ATTR -> const RayQuery& { return query; };
    const double until = query.ray.tmax;
    const AnyInstances instances(bvh);
    return bvh.predicts_branches(query.ray)
               ? find_any<BranchingLaneSelect>(bvh, same, until, local, tmin, boxes, instances)
               : find_any<BranchlessLaneSelect>(bvh, same, until, local, tmin, boxes, instances);
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
