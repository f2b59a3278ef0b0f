// Hits on instances, found by the intersectors of their objects.
#include "core/intersect/intersector.h"
#include "core/intersect/placement.h"

namespace etalon {

void Intersector::offer_instance(std::uint32_t item, const RayQuery& query, NearestHit& nearest,
                                 TraversalCost* cost) const {
    const std::uint32_t number = geometry_.instance_number(item);
    const InstanceAt instance(geometry_, number, query.ray.time());
    Ray ray = to_object(*instance, number, query.ray);
    const Intersector& object = *objects_[instance->object];
    const bool misses = misses_bounds(object.bounds_.space, ray);
    if (misses && !object.bounds_.has_more()) return;
    ray.tmax = nearest.t;
    const NearestHit hit = object.nearest_hit(ray, misses, cost);
    if (hit.found()) nearest.offer(hit.t, item, hit.item);
}

bool Intersector::instance_occludes(std::uint32_t item, const RayQuery& query) const {
    const std::uint32_t number = geometry_.instance_number(item);
    const InstanceAt instance(geometry_, number, query.ray.time());
    const Ray ray = to_object(*instance, number, query.ray);
    const Intersector& object = *objects_[instance->object];
    const bool misses = misses_bounds(object.bounds_.space, ray);
    return !(misses && !object.bounds_.has_more()) && object.is_occluded(ray, misses);
}

void Intersector::offer_entered(std::uint32_t item, const RayQuery& in_object,
                                const NormalizedRay& local, NearestHit& nearest) const {
    NearestHit hit(nearest.t);
    object_of(item).closest_bounded(in_object, local, hit);
    if (hit.found()) nearest.offer(hit.t, item, hit.item);
}

bool Intersector::entered_occludes(std::uint32_t item, const RayQuery& in_object,
                                   const NormalizedRay& local) const {
    return object_of(item).occluded_bounded(in_object, local);
}

const Intersector& Intersector::object_of(std::uint32_t item) const {
    return *objects_[geometry_.instances[geometry_.instance_number(item)].object];
}

}  // namespace etalon
