#include "native_accel/bvh/traversal.h"

#include <algorithm>
#include <bit>

#include "core/accel/clusters/instance_list.h"
#include "core/numerics/instruction_sets.h"
#include "native_accel/bvh/lane_select.h"
#include "native_accel/common/tally.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/bvh/traversal.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/accel/clusters/filter-inl.h"
#include "native_accel/bvh/traversal-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(t, id) for what could be hit at t <= tmax, for as long as it returns true.
template <class Offer>
HWY_INLINE void visit(const BvhView& bvh, ClusterRef ref, const ClusterFilter& filter, float tmax,
                      const RayQuery& query, const Offer& offer) {
    std::uint32_t lanes = filter.candidates(bvh.clusters, ref, tmax);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto [id, t] =
            bvh.clusters.intersect_lane(bvh.geometry, ref, std::countr_zero(lanes), query);
        if (!offer(t, id)) return;
    }
}

template <class LowestLane, class Counters>
HWY_INLINE void find_closest(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                             NearestHit& nearest, Counters counters) {
    const float tmin = local.tmin(query.ray.tmin);
    float tmax = local.tmax(nearest.t);
    StackSpace space;
    Traversal traversal(bvh.tree, local, tmin, space, FrontToBack<LowestLane>(), counters);
    if (!traversal.begin(tmax)) return;
    const ClusterFilter filter(bvh.clusters, query, local, tmin);
    const auto offer = [&](double t, std::uint32_t id) HWY_ATTR {
        nearest.offer(t, id);
        return true;
    };
    traversal.finish(tmax, [&](ClusterRef ref) HWY_ATTR {
        const double before = nearest.t;
        traversal.counters().members(bvh.clusters, ref);
        if (HWY_UNLIKELY(ref.kind() == ClusterRef::instances)) {
            offer_instances(bvh.instances, bvh.clusters, ref, query, nearest,
                            traversal.counters().sum());
        } else {
            visit(bvh, ref, filter, tmax, query, offer);
        }
        if (nearest.t < before) tmax = local.tmax(nearest.t);
        return true;
    });
}

void traverse_closest(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                      NearestHit& nearest) {
    if (bvh.predicts_branches(query.ray)) {
        find_closest<BranchingLaneSelect>(bvh, query, local, nearest, Uncounted());
    } else {
        find_closest<BranchlessLaneSelect>(bvh, query, local, nearest, Uncounted());
    }
}

void traverse_closest_counted(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                              NearestHit& nearest, TraversalCost& cost) {
    find_closest<BranchlessLaneSelect>(bvh, query, local, nearest, Counted{cost});
}

template <class LowestLane>
HWY_INLINE bool find_any(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local) {
    const float tmin = local.tmin(query.ray.tmin), tmax = local.tmax(query.ray.tmax);
    StackSpace space;
    Traversal traversal(bvh.tree, local, tmin, space, AnyOrder<LowestLane>(), Uncounted());
    if (!traversal.begin(tmax)) return false;
    const ClusterFilter filter(bvh.clusters, query, local, tmin);
    bool found = false;
    const auto offer = [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.ray.tmax;
        return !found;
    };
    traversal.finish(tmax, [&](ClusterRef ref) HWY_ATTR {
        if (HWY_UNLIKELY(ref.kind() == ClusterRef::instances)) {
            found = instances_occlude(bvh.instances, bvh.clusters, ref, query);
        } else {
            visit(bvh, ref, filter, tmax, query, offer);
        }
        return !found;
    });
    return found;
}

bool traverse_occluded(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local) {
    return bvh.predicts_branches(query.ray) ? find_any<BranchingLaneSelect>(bvh, query, local)
                                            : find_any<BranchlessLaneSelect>(bvh, query, local);
}

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
