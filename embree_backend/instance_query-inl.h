// Rays on their way into instances. Compiled for each instruction set.
#if defined(ETALON_INSTANCE_QUERY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_INSTANCE_QUERY_INL_H
#undef ETALON_INSTANCE_QUERY_INL_H
#else
#define ETALON_INSTANCE_QUERY_INL_H
#endif

#include "core/intersect/object_ray-inl.h"
#include "embree_backend/user_query-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32

/// Offers `nearest` what a ray that enters an object hits of it. `local` is `ray` in its space.
HWY_INLINE void offer_entered(const UserQuery& query, std::uint32_t item, const Instance& instance,
                              const ObjectRay& ray, const NormalizedRay& local,
                              NearestHit& nearest) {
    const RayQuery inside(
        ray.ray(query.query.ray, nearest.t, query.view.geometry.instance_number(item)));
    if (HWY_UNLIKELY(query.view.entered == nullptr)) {
        return query.view.instances.offer_entered(item, inside, local, nearest);
    }
    RTCRayHit entered;
    set_ray(entered.ray, local, local.tmin(inside.ray.tmin), local.tmax(nearest.t));
    NearestHit hit(nearest.t);
    intersect(query.view.entered[instance.object], inside, local, hit, entered);
    if (hit.found()) nearest.offer(hit.t, item, hit.item);
}

HWY_INLINE bool entered_occludes(const UserQuery& query, std::uint32_t item,
                                 const Instance& instance, const ObjectRay& ray,
                                 const NormalizedRay& local) {
    const RayQuery inside(
        ray.ray(query.query.ray, query.query.ray.tmax, query.view.geometry.instance_number(item)));
    if (HWY_UNLIKELY(query.view.entered == nullptr)) {
        return query.view.instances.entered_occludes(item, inside, local);
    }
    RTCRay entered;
    if (!set_occlusion_ray(entered, local, local.tmin(inside.ray.tmin),
                           local.tmax(inside.ray.tmax))) {
        return false;
    }
    occluded(query.view.entered[instance.object], inside, local, entered);
    return entered.tfar < 0;
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

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
