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

/// Made for the first cluster that a ray meets: many rays meet none of one kind, or none at all.
template <class Filter>
class Late {
  public:
    HWY_INLINE Late() {}

    template <class... Arguments>
    HWY_INLINE const Filter& get(const Arguments&... arguments) {
        if (!made_) new (&filter_) Filter(arguments...);
        made_ = true;
        return filter_;
    }

  private:
    union {
        Filter filter_;
    };
    bool made_ = false;
};

/// What the callbacks need of a ray: Embree hands them the context it was given.
struct UserQuery : EmbreeContext {
    HWY_INLINE UserQuery(const UserView& view, const RayQuery& q, const FrameRay& l, NearestHit* n)
        : scene(view.scene),
          clusters(view.clusters),
          singles(view.singles),
          query(q),
          local(l),
          nearest(n) {
        initialise(*this);
    }

    /// Before 0 in the frame there is nothing.
    template <ClusterRef::Kind kind>
    HWY_INLINE std::uint32_t candidates(std::uint32_t cluster, float tmax) {
        const ClusterRef ref(kind, cluster);
        const std::uint32_t left = query.ray.left;
        if constexpr (kind == ClusterRef::triangles) {
            return triangles.get(local, left).candidates(clusters.triangles(ref), tmax);
        } else {
            return spheres.get(local, std::max(0.0F, local.tmin(query.ray.tmin)), left)
                .candidates(clusters.spheres(ref), tmax);
        }
    }

    const Scene& scene;
    const Clusters& clusters;
    const PrimitiveIds& singles;
    const RayQuery& query;
    const FrameRay& local;
    NearestHit* nearest;
    Late<TriangleFilter> triangles;
    Late<SphereFilter> spheres;
};

/// Embree's single-ray layout is what a packet of one is.
template <class Ray, class PacketOfOne>
HWY_INLINE Ray& single(PacketOfOne* packet) {
    return *reinterpret_cast<Ray*>(packet);
}

/// Calls offer(t, id) for what could be hit at t <= tmax in the frame, as long as it returns true.
template <ClusterRef::Kind kind, class Offer>
HWY_INLINE void visit(UserQuery& query, std::uint32_t cluster, float tmax, const Offer& offer) {
    if constexpr (kind == ClusterRef::list) {
        const std::uint32_t id = query.singles[cluster];
        offer(primitive_first_hit(query.scene, id, query.query), id);
    } else {
        std::uint32_t lanes = query.candidates<kind>(cluster, tmax);
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto [id, t] = query.clusters.ask(query.scene, ClusterRef(kind, cluster),
                                                    std::countr_zero(lanes), query.query);
            if (!offer(t, id)) return;
        }
    }
}

/// What is offered at t may lie behind a hit that is not in `nearest`: one on a geometry of
/// Embree's own, which its tfar tells.
template <ClusterRef::Kind kind>
void intersect_cluster(const RTCIntersectFunctionNArguments* arguments) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    auto& [ray, hit] = single<RTCRayHit>(arguments->rayhit);
    bool found = false;
    visit<kind>(query, arguments->primID, ray.tfar, [&](double t, std::uint32_t id) HWY_ATTR {
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
    auto& query = *static_cast<UserQuery*>(arguments->context);
    auto& ray = single<RTCRay>(arguments->ray);
    bool found = false;
    visit<kind>(query, arguments->primID, ray.tfar, [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.query.ray.tmax;
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
