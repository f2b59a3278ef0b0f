// Traversal of instance trees. Compiled for each instruction set.
#if defined(ETALON_INSTANCE_TREE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_INSTANCE_TREE_INL_H
#undef ETALON_INSTANCE_TREE_INL_H
#else
#define ETALON_INSTANCE_TREE_INL_H
#endif

#include <algorithm>
#include <bit>

#include "core/accel/wide/fine_slabs-inl.h"
#include "core/accel/wide/lane_select.h"
#include "core/accel/wide/pairwise-inl.h"
#include "core/accel/wide/traversal-inl.h"
#include "core/accel/wide/traversal_counters.h"
#include "core/intersect/normalized_ray.h"
#include "embree_backend/instance_query-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// The item of a leaf, which is a single instance.
HWY_INLINE std::uint32_t item_of(const Geometry& geometry, ClusterRef leaf) {
    return static_cast<std::uint32_t>(geometry.primitives.size()) + leaf.instance();
}

/// Offers `nearest` the instances of a tree that the ray may hit: all of them if its space is too
/// fine for the ray.
inline HWY_NOINLINE void offer_tree(const UserQuery& query, const InstanceTree& tree,
                                    NearestHit& nearest) {
    const Ray& ray = query.query.ray;
    if (HWY_UNLIKELY(!is_resolved(tree.space, ray))) {
        for (const std::uint32_t item : tree.items) offer_instance(query, item, nearest);
        return;
    }
    const auto local = normalized_ray(tree.space, ray);
    if (!local) return;
    const FineSlabs boxes(*local, local->tmin(ray.tmin),
                          fine_ray(tree.space, tree.spread, ray, *local));
    float tmax = local->tmax(nearest.t);
    StackSpace space;
    Traversal traversal(tree.wide, boxes, space, FrontToBack<BranchlessLaneSelect>(), Uncounted());
    if (!traversal.begin(tmax)) return;
    traversal.finish(tmax, [&](ClusterRef leaf) HWY_ATTR {
        const double before = nearest.t;
        offer_instance(query, item_of(query.view.geometry, leaf), nearest);
        if (nearest.t < before) tmax = local->tmax(nearest.t);
        return true;
    });
}

inline HWY_NOINLINE bool tree_occludes(const UserQuery& query, const InstanceTree& tree) {
    const Ray& ray = query.query.ray;
    if (HWY_UNLIKELY(!is_resolved(tree.space, ray))) {
        return std::ranges::any_of(
            tree.items, [&](std::uint32_t item) { return instance_occludes(query, item); });
    }
    const auto local = normalized_ray(tree.space, ray);
    if (!local) return false;
    const FineSlabs boxes(*local, local->tmin(ray.tmin),
                          fine_ray(tree.space, tree.spread, ray, *local));
    PairwiseTraversal traversal(tree.wide, boxes, local->tmax(ray.tmax));
    return traversal.begin() && traversal.finish([&](ClusterRef leaf) HWY_ATTR {
        return instance_occludes(query, item_of(query.view.geometry, leaf));
    });
}

/// Returns the lanes, lowest first, whose box contains a point.
HWY_INLINE std::uint32_t lanes_about(const WideNode& node, const Vec3f& point) {
    return lanes_where([&](std::size_t i) HWY_ATTR {
        Floats outside = hn::Zero(Tag());
        for (int k = 0; k < 3; ++k) {
            const Floats p = broadcast(point[k]);
            const Floats low = hn::Load(Tag(), &node.planes[WideNode::plane(k, false) + i]);
            const Floats high = hn::Load(Tag(), &node.planes[WideNode::plane(k, true) + i]);
            outside = hn::Max(outside, hn::Max(hn::Sub(low, p), hn::Sub(p, high)));
        }
        return hn::Le(outside, hn::Zero(Tag()));
    });
}

/// Visits the tree with the smallest box about the ray's start, of those with the most instances:
/// what the ray hits first is likely to be there, but Embree visits all boxes about the start in
/// any order.
inline HWY_NOINLINE void visit_tree_about_start(UserQuery& query, RTCRay& ray) {
    const WideNode& trees = query.view.trees.largest();
    const std::uint32_t about = lanes_about(trees, query.local.origin);
    if (about == 0) return;
    query.visited_tree = trees.children[std::countr_zero(about)].node();
    NearestHit nearest = *query.nearest;
    offer_tree(query, query.view.trees[query.visited_tree], nearest);
    query.take_over(nearest, ray);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
