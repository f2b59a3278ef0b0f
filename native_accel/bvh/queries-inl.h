// The queries of the tree: closest hit and occlusion. Compiled for each instruction set.
#if defined(ETALON_BVH_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_BVH_QUERIES_INL_H
#undef ETALON_BVH_QUERIES_INL_H
#else
#define ETALON_BVH_QUERIES_INL_H
#endif

#include <algorithm>
#include <bit>

#include "core/accel/clusters/filter-inl.h"
#include "core/accel/clusters/instance_list.h"
#include "core/accel/wide/lane_select.h"
#include "core/accel/wide/pairwise-inl.h"
#include "core/accel/wide/traversal-inl.h"
#include "core/accel/wide/traversal_counters.h"
#include "native_accel/bvh/traversal.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(t, id) for all that could be hit at t <= tmax, as long as it returns true.
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

/// Answers queries for instances by the intersectors of their objects.
class AnyInstances {
  public:
    HWY_INLINE explicit AnyInstances(const BvhView& bvh) : bvh_(bvh) {}

    HWY_INLINE void offer(ClusterRef ref, const RayQuery& query, NearestHit& nearest,
                          TraversalCost* cost) const {
        offer_instances(bvh_.instances, bvh_.clusters, ref, query, nearest, cost);
    }
    HWY_INLINE bool occlude(ClusterRef ref, const RayQuery& query) const {
        return instances_occlude(bvh_.instances, bvh_.clusters, ref, query);
    }

  private:
    const BvhView& bvh_;
};

/// Offers `nearest` all that could be hit. `boxes` is a SlabTest of the ray from `tmin` on;
/// make_query() returns the ray's RayQuery, and is called only if the ray enters the tree.
template <class LowestLane, class MakeQuery, class Boxes, class Instances, class Counters>
HWY_INLINE void find_closest(const BvhView& bvh, const MakeQuery& make_query,
                             const NormalizedRay& local, float tmin, const Boxes& boxes,
                             const Instances& instances, NearestHit& nearest, Counters counters) {
    float tmax = local.tmax(nearest.t);
    StackSpace space;
    Traversal traversal(bvh.tree, boxes, space, FrontToBack<LowestLane>(), counters);
    if (!traversal.begin(tmax)) return;
    const RayQuery& query = make_query();
    const ClusterFilter filter(bvh.clusters, query, local, tmin);
    const auto offer = [&](double t, std::uint32_t id) HWY_ATTR {
        nearest.offer(t, id);
        return true;
    };
    traversal.finish(tmax, [&](ClusterRef ref) HWY_ATTR {
        const double before = nearest.t;
        traversal.counters().members(bvh.clusters, ref);
        if (HWY_UNLIKELY(ref.kind() == ClusterRef::instances)) {
            instances.offer(ref, query, nearest, traversal.counters().sum());
        } else {
            visit(bvh, ref, filter, tmax, query, offer);
        }
        if (nearest.t < before) tmax = local.tmax(nearest.t);
        return true;
    });
}

/// Returns whether any member of a cluster is hit at t <= query.ray.tmax, which is no later than
/// `tmax`.
template <class Instances>
HWY_INLINE bool is_hit(const BvhView& bvh, ClusterRef ref, const ClusterFilter& filter, float tmax,
                       const RayQuery& query, const Instances& instances) {
    if (HWY_UNLIKELY(ref.kind() == ClusterRef::instances)) return instances.occlude(ref, query);
    bool found = false;
    visit(bvh, ref, filter, tmax, query, [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.ray.tmax;
        return !found;
    });
    return found;
}

/// Returns whether anything is hit at t <= `until`, the ray's tmax; arguments as for
/// find_closest().
template <class LowestLane, class MakeQuery, class Boxes, class Instances>
HWY_INLINE bool find_any(const BvhView& bvh, const MakeQuery& make_query, double until,
                         const NormalizedRay& local, float tmin, const Boxes& boxes,
                         const Instances& instances) {
    const float tmax = local.tmax(until);
    StackSpace space;
    Traversal traversal(bvh.tree, boxes, space, AnyOrder<LowestLane>(), Uncounted());
    if (!traversal.begin(tmax)) return false;
    const RayQuery& query = make_query();
    const ClusterFilter filter(bvh.clusters, query, local, tmin);
    bool found = false;
    traversal.finish(tmax, [&](ClusterRef ref) HWY_ATTR {
        found = is_hit(bvh, ref, filter, tmax, query, instances);
        return !found;
    });
    return found;
}

/// The same for trees of instances, whose boxes overlap: a ray enters many nodes.
template <class Boxes, class Instances>
HWY_INLINE bool find_any_in_pairs(const BvhView& bvh, const RayQuery& query,
                                  const NormalizedRay& local, float tmin, const Boxes& boxes,
                                  const Instances& instances) {
    const float tmax = local.tmax(query.ray.tmax);
    PairwiseTraversal traversal(bvh.tree, boxes, tmax);
    if (!traversal.begin()) return false;
    const ClusterFilter filter(bvh.clusters, query, local, tmin);
    return traversal.finish(
        [&](ClusterRef ref) HWY_ATTR { return is_hit(bvh, ref, filter, tmax, query, instances); });
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
