#include "embree_backend/user_tracing.h"

#include <bit>

#include "core/intersect/kernels.h"
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "embree_backend/user_tracing.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "embree_backend/instance_callbacks-inl.h"
#include "embree_backend/user_query-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(t, id) for each of `lanes` of a cluster, as long as it returns true.
template <ClusterRef::Kind kind, class Offer>
HWY_INLINE void test_lanes(const UserQuery& query, std::uint32_t cluster, std::uint32_t lanes,
                           const Offer& offer) {
    if constexpr (kind == ClusterRef::list) {
        const std::uint32_t id = query.view.singles[cluster];
        offer(primitive_first_hit(query.view.geometry, id, query.query), id);
    } else {
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto [id, t] =
                query.view.clusters.intersect_lane(query.view.geometry, ClusterRef(kind, cluster),
                                                   std::countr_zero(lanes), query.query);
            if (!offer(t, id)) return;
        }
    }
}

/// Intersects candidates. A hit at t may lie behind one that is not in `nearest`: a hit on one of
/// Embree's own geometries, whose t is in tfar.
template <ClusterRef::Kind kind>
HWY_NOINLINE void intersect_candidates(const RTCIntersectFunctionNArguments* arguments,
                                       std::uint32_t lanes) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    auto& asked = single<RTCRayHit>(arguments->rayhit);
    bool found = false;
    test_lanes<kind>(query, arguments->primID, lanes, [&](double t, std::uint32_t id) HWY_ATTR {
        if (!(t <= query.nearest->t)) return true;
        const float tfar = query.local.tmax(t);
        if (tfar > asked.ray.tfar) return true;
        query.nearest->offer(t, id);
        asked.ray.tfar = tfar;
        return found = true;
    });
    if (found) asked.hit.geomID = arguments->geomID;
    report(*arguments, found);
}

template <ClusterRef::Kind kind>
HWY_NOINLINE void occluded_candidates(const RTCOccludedFunctionNArguments* arguments,
                                      std::uint32_t lanes) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    auto& ray = single<RTCRay>(arguments->ray);
    bool found = false;
    test_lanes<kind>(query, arguments->primID, lanes, [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.query.ray.tmax;
        return !found;
    });
    if (found) ray.tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, found);
}

/// Intersects a cluster. Most clusters have no candidate, so the code for candidates is apart and
/// these need no stack frame.
template <ClusterRef::Kind kind>
void intersect_cluster(const RTCIntersectFunctionNArguments* arguments) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    if constexpr (kind == ClusterRef::list) {
        const std::uint32_t item = query.view.singles[arguments->primID];
        if (query.view.geometry.is_instance(item)) return intersect_instance(arguments, item);
    }
    const RTCRay& ray = single<RTCRayHit>(arguments->rayhit).ray;
    const std::uint32_t lanes = query.candidates<kind>(arguments->primID, ray);
    if (lanes != 0) return intersect_candidates<kind>(arguments, lanes);
    report(*arguments, false);
}

template <ClusterRef::Kind kind>
void occluded_cluster(const RTCOccludedFunctionNArguments* arguments) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    if constexpr (kind == ClusterRef::list) {
        const std::uint32_t item = query.view.singles[arguments->primID];
        if (query.view.geometry.is_instance(item)) return occluded_by_instance(arguments, item);
    }
    const RTCRay& ray = single<RTCRay>(arguments->ray);
    const std::uint32_t lanes = query.candidates<kind>(arguments->primID, ray);
    if (lanes != 0) return occluded_candidates<kind>(arguments, lanes);
    report(*arguments, false);
}

template <ClusterRef::Kind kind>
constexpr UserTracing::Callbacks callbacks = {intersect_cluster<kind>, occluded_cluster<kind>};

UserTracing user_tracing() {
    return {{callbacks<ClusterRef::list>, callbacks<ClusterRef::triangles>,
             callbacks<ClusterRef::spheres>},
            intersect,
            occluded};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(user_tracing);

UserTracing user_tracing() {
    return HWY_DYNAMIC_DISPATCH(user_tracing)();
}

}  // namespace etalon
#endif
