#include "embree_backend/user_tracing.h"

#include <algorithm>
#include <bit>

#include "core/intersect/kernels.h"
#include "core/numerics/instruction_sets.h"
#include "embree_backend/nested_scene.h"
#include "embree_backend/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "embree_backend/user_tracing.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/accel/clusters/filter-inl.h"
#include "core/intersect/object_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Filter that is lazily made for the first cluster a ray meets: many rays meet none of one kind.
template <class Filter>
class Lazy {
  public:
    HWY_INLINE Lazy() {}

    template <class Make>
    HWY_INLINE const Filter& get(const Make& make) {
        if (HWY_UNLIKELY(!made_)) new (&filter_) Filter(make());
        made_ = true;
        return filter_;
    }

  private:
    union {
        Filter filter_;
    };
    bool made_ = false;
};

/// Input of the callbacks for one ray: Embree passes them the context that it was given.
struct UserQuery : EmbreeContext {
    HWY_INLINE UserQuery(const UserView& v, const RayQuery& q, const NormalizedRay& l,
                         NearestHit* n)
        : view(v), query(q), local(l), nearest(n) {
        initialise(*this);
    }

    /// Returns the nested scene with a number that is not an item's, else null.
    const NestedScene* nested(std::uint32_t number) const {
        const std::uint32_t items = view.geometry.item_count();
        return number < items ? nullptr : view.nested_scenes[number - items].get();
    }

    /// Returns the lanes, lowest first, that the ray could hit from its tnear to its tfar; one lane
    /// for items without a filter.
    template <ClusterRef::Kind kind>
    HWY_INLINE std::uint32_t candidates(std::uint32_t cluster, const RTCRay& ray) {
        const ClusterRef ref(kind, cluster);
        if constexpr (kind == ClusterRef::list) return 1;
        if constexpr (kind == ClusterRef::triangles) {
            const auto make = [&]() HWY_ATTR { return TriangleFilter(query, local); };
            return triangles.get(make).candidates(view.clusters.triangles(ref), ray.tfar);
        }
        if constexpr (kind == ClusterRef::spheres) {
            const auto make = [&]() HWY_ATTR {
                return SphereFilter(local, ray.tnear, query.ray.exclude);
            };
            return spheres.get(make).candidates(view.clusters.spheres(ref), ray.tfar);
        }
    }

    const UserView& view;
    const RayQuery& query;
    const NormalizedRay& local;
    NearestHit* nearest;
    Lazy<TriangleFilter> triangles;
    Lazy<SphereFilter> spheres;
};

void intersect(const UserView& view, const RayQuery& query, const NormalizedRay& local,
               NearestHit& nearest, RTCRayHit& ray) {
    UserQuery context(view, query, local, &nearest);
    embree_intersect(view.target, context, ray);
}

void occluded(const UserView& view, const RayQuery& query, const NormalizedRay& local,
              RTCRay& ray) {
    UserQuery context(view, query, local, nullptr);
    embree_occluded(view.target, context, ray);
}

/// Returns the ray of a packet of one, which has the layout of a single ray.
template <class Ray, class PacketOfOne>
HWY_INLINE Ray& single(PacketOfOne* packet) {
    return *reinterpret_cast<Ray*>(packet);
}

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

#if HWY_MAX_BYTES >= 32

/// Offers `nearest` what a ray that enters an object hits of it. `local` is `ray` in its space.
HWY_INLINE void offer_entered(const UserQuery& query, std::uint32_t item, const Instance& instance,
                              const ObjectRay& ray, const NormalizedRay& local,
                              NearestHit& nearest) {
    const RayQuery inside(ray.ray(query.query.ray, nearest.t));
    if (HWY_UNLIKELY(query.view.entered == nullptr)) {
        return query.view.instances.offer_entered(item, inside, local, nearest);
    }
    RTCRayHit asked;
    set_ray(asked.ray, local, local.tmin(inside.ray.tmin), local.tmax(nearest.t));
    NearestHit hit(nearest.t);
    intersect(query.view.entered[instance.object], inside, local, hit, asked);
    if (hit.found()) nearest.offer(hit.t, item, hit.item);
}

HWY_INLINE bool entered_occludes(const UserQuery& query, std::uint32_t item,
                                 const Instance& instance, const ObjectRay& ray,
                                 const NormalizedRay& local) {
    const RayQuery inside(ray.ray(query.query.ray, query.query.ray.tmax));
    if (HWY_UNLIKELY(query.view.entered == nullptr)) {
        return query.view.instances.entered_occludes(item, inside, local);
    }
    const float tfar = local.tmax(inside.ray.tmax);
    if (tfar < 0) return false;  // which is how Embree would tell that there is a hit
    RTCRay asked;
    set_ray(asked, local, local.tmin(inside.ray.tmin), tfar);
    occluded(query.view.entered[instance.object], inside, local, asked);
    return asked.tfar < 0;
}

/// Offers `nearest` an instance: most objects that a ray is taken to are passed.
HWY_INLINE void offer_instance(const UserQuery& query, std::uint32_t item, NearestHit& nearest) {
    const Instance& instance =
        query.view.geometry.instances[query.view.geometry.instance_number(item)];
    if (HWY_UNLIKELY(instance.moves())) {
        return query.view.instances.offer_instance(item, query.query, nearest);
    }
    const ObjectRay ray(instance, WorldRayLanes(query.query.ray));
    NormalizedRay local;
    const ObjectEntry entry = ray.entry(query.view.objects[instance.object], local);
    if (entry == ObjectEntry::misses) return;
    if (HWY_UNLIKELY(entry == ObjectEntry::slow_path)) {
        return query.view.instances.offer_instance(item, query.query, nearest);
    }
    offer_entered(query, item, instance, ray, local, nearest);
}

HWY_INLINE bool instance_occludes(const UserQuery& query, std::uint32_t item) {
    const Instance& instance =
        query.view.geometry.instances[query.view.geometry.instance_number(item)];
    if (HWY_UNLIKELY(instance.moves())) {
        return query.view.instances.instance_occludes(item, query.query);
    }
    const ObjectRay ray(instance, WorldRayLanes(query.query.ray));
    NormalizedRay local;
    const ObjectEntry entry = ray.entry(query.view.objects[instance.object], local);
    if (entry == ObjectEntry::misses) return false;
    if (HWY_UNLIKELY(entry == ObjectEntry::slow_path)) {
        return query.view.instances.instance_occludes(item, query.query);
    }
    return entered_occludes(query, item, instance, ray, local);
}

#else

HWY_INLINE void offer_instance(const UserQuery& query, std::uint32_t item, NearestHit& nearest) {
    query.view.instances.offer_instance(item, query.query, nearest);
}

HWY_INLINE bool instance_occludes(const UserQuery& query, std::uint32_t item) {
    return query.view.instances.instance_occludes(item, query.query);
}

#endif

/// Intersects an instance or a nested scene; see intersect_candidates.
HWY_NOINLINE void intersect_instance(const RTCIntersectFunctionNArguments* arguments,
                                     std::uint32_t item) {
    auto& query = *static_cast<UserQuery*>(arguments->context);
    auto& [ray, hit] = single<RTCRayHit>(arguments->rayhit);
    NearestHit nearest = *query.nearest;
    if (const NestedScene* nested = query.nested(item)) {
        nested->offer(query.query, nearest);
    } else {
        offer_instance(query, item, nearest);
    }
    const bool beats = nearest.t < query.nearest->t || nearest.item != query.nearest->item;
    const float tfar = beats ? query.local.tmax(nearest.t) : 0;
    const bool found = beats && !(tfar > ray.tfar);
    if (found) {
        *query.nearest = nearest;
        ray.tfar = tfar;
        hit.geomID = arguments->geomID;
    }
    report(*arguments, found);
}

HWY_NOINLINE void occluded_by_instance(const RTCOccludedFunctionNArguments* arguments,
                                       std::uint32_t item) {
    const auto& query = *static_cast<const UserQuery*>(arguments->context);
    const NestedScene* nested = query.nested(item);
    const bool found =
        nested != nullptr ? nested->occludes(query.query) : instance_occludes(query, item);
    if (found) single<RTCRay>(arguments->ray).tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, found);
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
