#include "embree_backend/user_tracing.h"

#include <algorithm>
#include <bit>

#include "core/intersect/clusters/targets.h"
#include "core/intersect/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "embree_backend/user_tracing.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/intersect/clusters/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// What the callbacks need of a ray: Embree hands them the context it was given.
struct UserQuery : EmbreeContext {
    /// Before 0 in the frame there is nothing.
    HWY_INLINE UserQuery(const UserView& view, const RayQuery& q, const FrameRay& l, NearestHit* n)
        : filter(l, std::max(0.0F, l.tmin(q.ray.tmin))),
          scene(view.scene),
          clusters(view.clusters),
          query(q),
          local(l),
          nearest(n) {
        initialise(*this);
    }

    ClusterFilter filter;
    const Scene& scene;
    const Clusters& clusters;
    const RayQuery& query;
    const FrameRay& local;
    NearestHit* nearest;
};

/// Embree's single-ray layout is what a packet of one is.
template <class Ray, class PacketOfOne>
HWY_INLINE Ray& single(PacketOfOne* packet) {
    return *reinterpret_cast<Ray*>(packet);
}

/// Calls offer(id) for what could be hit at t <= tmax in the frame, as long as it returns true.
template <ClusterRef::Kind kind, class Offer>
HWY_INLINE void visit(const UserQuery& query, std::uint32_t cluster, float tmax,
                      const Offer& offer) {
    const ClusterRef ref(kind, cluster);
    std::uint32_t lanes = query.filter.candidates(query.clusters, ref, tmax);
    for (; lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t id = query.clusters.ids(ref)[std::countr_zero(lanes)];
        if (id == no_index || !offer(id)) return;
    }
}

/// What is offered at t may lie behind a hit that is not in `nearest`: one on a geometry of
/// Embree's own, which its tfar tells.
template <ClusterRef::Kind kind>
void intersect_cluster(const RTCIntersectFunctionNArguments* arguments) {
    const auto& query = *static_cast<const UserQuery*>(arguments->context);
    auto& [ray, hit] = single<RTCRayHit>(arguments->rayhit);
    bool found = false;
    visit<kind>(query, arguments->primID, ray.tfar, [&](std::uint32_t id) HWY_ATTR {
        const double t = primitive_first_hit(query.scene, id, query.query);
        if (!(t <= query.nearest->t)) return true;
        const float tfar = query.local.tmax(t);
        if (tfar > ray.tfar) return true;
        query.nearest->offer(t, id);
        ray.tfar = tfar;
        return found = true;
    });
    if (found) hit.geomID = arguments->geomID;
    report(*arguments, found);
}

template <ClusterRef::Kind kind>
void occluded_cluster(const RTCOccludedFunctionNArguments* arguments) {
    const auto& query = *static_cast<const UserQuery*>(arguments->context);
    auto& ray = single<RTCRay>(arguments->ray);
    bool found = false;
    visit<kind>(query, arguments->primID, ray.tfar, [&](std::uint32_t id) HWY_ATTR {
        found = primitive_first_hit(query.scene, id, query.query) <= query.query.ray.tmax;
        return !found;
    });
    if (found) ray.tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, found);
}

void intersect(const UserView& view, const RayQuery& query, const FrameRay& local,
               NearestHit& nearest, RTCRayHit& ray) {
    UserQuery context(view, query, local, &nearest);
    embree_intersect(view.target, context, ray);
}

void occluded(const UserView& view, const RayQuery& query, const FrameRay& local, RTCRay& ray) {
    UserQuery context(view, query, local, nullptr);
    embree_occluded(view.target, context, ray);
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
