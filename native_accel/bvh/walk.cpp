#include "native_accel/bvh/walk.h"

#include <algorithm>
#include <bit>
#include <cctype>

#include "core/intersect/clusters/targets.h"
#include "native_accel/bvh/stack.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/bvh/walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/intersect/clusters/filter-inl.h"
#include "native_accel/bvh/slabs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(t, id) for what could be hit at t <= tmax, for as long as it returns true.
template <class Offer>
HWY_INLINE void visit(const BvhView& bvh, ClusterRef ref, const ClusterFilter& filter, float tmax,
                      const RayQuery& query, const Offer& offer) {
    std::uint32_t lanes = filter.candidates(bvh.clusters, ref, tmax);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto [id, t] = bvh.clusters.ask(bvh.scene, ref, std::countr_zero(lanes), query);
        if (!offer(t, id)) return;
    }
}

/// Before 0 in the frame there is nothing.
HWY_INLINE float start(const RayQuery& query, const FrameRay& local) {
    return std::max(0.0F, local.tmin(query.ray.tmin));
}

/// Takes the tree's leaves one by one to at_leaf(cluster), for as long as that returns true.
/// descend(stack, node, entry, lanes) picks which of the children that are entered is next.
template <class Descend, class AtLeaf>
HWY_INLINE void walk(const WideTree& tree, const Slabs& slabs, const float& tmax,
                     const Descend& descend, const AtLeaf& at_leaf) {
    StackSpace space;
    TraversalStack stack(space);
    ChildRef next = tree.root;
    do {
        while (!next.is_leaf()) {
            const WideNode& node = tree.nodes[next.node()];
            alignas(32) Lanes entry;
            const std::uint32_t entered = slabs.entered(node, tmax, entry);
            if (entered == 0) break;
            next = descend(stack, node, entry, entered);
        }
        if (next.is_leaf() && !at_leaf(next.cluster())) return;
    } while (stack.pop(tmax, next));
}

void walk_closest(const BvhView& bvh, const RayQuery& query, const FrameRay& local,
                  NearestHit& nearest) {
    const float tmin = start(query, local);
    float tmax = local.tmax(nearest.t);
    const ClusterFilter filter(local, tmin);
    const auto offer = [&](double t, std::uint32_t id) HWY_ATTR {
        nearest.offer(t, id);
        return true;
    };
    const auto nearest_first =
        [](TraversalStack& stack, const WideNode& node, const Lanes& entry, std::uint32_t entered)
            HWY_ATTR { return stack.descend(node, entry, entered); };
    walk(bvh.tree, Slabs(local, tmin), tmax, nearest_first, [&](ClusterRef ref) HWY_ATTR {
        const double before = nearest.t;
        visit(bvh, ref, filter, tmax, query, offer);
        if (nearest.t < before) tmax = local.tmax(nearest.t);
        return true;
    });
}

bool walk_occluded(const BvhView& bvh, const RayQuery& query, const FrameRay& local) {
    const float tmin = start(query, local), tmax = local.tmax(query.ray.tmax);
    const ClusterFilter filter(local, tmin);
    bool found = false;
    const auto offer = [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.ray.tmax;
        return !found;
    };
    const auto as_they_come =
        [](TraversalStack& stack, const WideNode& node, const Lanes&, std::uint32_t entered)
            HWY_ATTR { return stack.descend(node, entered); };
    walk(bvh.tree, Slabs(local, tmin), tmax, as_they_come, [&](ClusterRef ref) HWY_ATTR {
        visit(bvh, ref, filter, tmax, query, offer);
        return !found;
    });
    return found;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(walk_closest);
HWY_EXPORT(walk_occluded);

void walk_closest(const BvhView& bvh, const RayQuery& query, const FrameRay& local,
                  NearestHit& nearest) {
    HWY_DYNAMIC_DISPATCH(walk_closest)(bvh, query, local, nearest);
}

bool walk_occluded(const BvhView& bvh, const RayQuery& query, const FrameRay& local) {
    return HWY_DYNAMIC_DISPATCH(walk_occluded)(bvh, query, local);
}

std::string walk_isa() {
    const std::int64_t supported = hwy::SupportedTargets() & HWY_TARGETS;
    std::string name = hwy::TargetName(supported & -supported);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return name;
}

}  // namespace etalon
#endif
