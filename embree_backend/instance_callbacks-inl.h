// Callbacks for instances and trees of them. Compiled for each instruction set.
#if defined(ETALON_INSTANCE_CALLBACKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_INSTANCE_CALLBACKS_INL_H
#undef ETALON_INSTANCE_CALLBACKS_INL_H
#else
#define ETALON_INSTANCE_CALLBACKS_INL_H
#endif

#include <limits>

#include "embree_backend/instance_query-inl.h"
#include "embree_backend/instance_tree-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Intersects an instance, or an instance tree that has not been visited.
inline HWY_NOINLINE void intersect_instance(const RTCIntersectFunctionNArguments* arguments,
                                            std::uint32_t item) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    auto& [ray, hit] = single<RTCRayHit>(arguments->rayhit);
    NearestHit nearest = *query.nearest;
    if (!query.is_tree(item)) {
        offer_instance(query, item, nearest);
    } else if (query.tree_index(item) != query.visited_tree) {
        offer_tree(query, query.view.trees[query.tree_index(item)], nearest);
    }
    const bool found = query.take_over(nearest, ray);
    if (found) hit.geomID = arguments->geomID;
    report(*arguments, found);
}

inline HWY_NOINLINE void occluded_by_instance(const RTCOccludedFunctionNArguments* arguments,
                                              std::uint32_t item) {
    const auto& query = *static_cast<const UserQuery*>(arguments->context);
    const bool found = query.is_tree(item)
                           ? tree_occludes(query, query.view.trees[query.tree_index(item)])
                           : instance_occludes(query, item);
    if (found) single<RTCRay>(arguments->ray).tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, found);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
