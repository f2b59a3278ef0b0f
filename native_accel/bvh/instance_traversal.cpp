// In a file apart from the traversal without instances, which is inlined less if both are in one.
#include "core/intersect/normalized_ray.h"
#include "core/numerics/instruction_sets.h"
#include "native_accel/bvh/traversal.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/bvh/instance_traversal.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/accel/wide/fine_slabs-inl.h"
#include "native_accel/bvh/object_entry-inl.h"
#include "native_accel/bvh/queries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace {

void traverse_closest(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                      NearestHit& nearest) {
    const float tmin = local.tmin(query.ray.tmin);
    const FineSlabs boxes(local, tmin,
                          fine_ray(bvh.bounds.space, bvh.bounds.spread, query.ray, local));
    const auto same = [&]() HWY_ATTR -> const RayQuery& { return query; };
    const EnteredInstances instances(bvh, query.ray);
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
    const FineSlabs boxes(local, tmin,
                          fine_ray(bvh.bounds.space, bvh.bounds.spread, query.ray, local));
    const auto same = [&]() HWY_ATTR -> const RayQuery& { return query; };
    find_closest<BranchlessLaneSelect>(bvh, same, local, tmin, boxes, AnyInstances(bvh), nearest,
                                       Counted{cost});
}

bool traverse_occluded(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local) {
    const float tmin = local.tmin(query.ray.tmin);
    const FineSlabs boxes(local, tmin,
                          fine_ray(bvh.bounds.space, bvh.bounds.spread, query.ray, local));
    return find_any_in_pairs(bvh, query, local, tmin, boxes, EnteredInstances(bvh, query.ray));
}

}  // namespace

BvhTraversal bvh_instance_traversal() {
    return {traverse_closest, traverse_closest_counted, traverse_occluded};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(bvh_instance_traversal);

BvhTraversal bvh_instance_traversal() {
    return HWY_DYNAMIC_DISPATCH(bvh_instance_traversal)();
}

}  // namespace etalon
#endif
