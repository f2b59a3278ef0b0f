#include "core/intersect/intersector.h"

#include <algorithm>

#include "core/intersect/kernels.h"
#include "core/intersect/local_rays.h"
#include "core/intersect/object_space.h"
#include "core/intersect/packet_kernels.h"
#include "core/intersect/placement.h"
#include "core/intersect/rescaled_ray.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Returns whether there are some unbounded primitives, all of them planes that a packet can be
/// tested against.
bool are_planes(const Geometry& geometry, std::span<const std::uint32_t> items) {
    return !items.empty() && std::ranges::all_of(items, [&](std::uint32_t item) {
        if (geometry.is_instance(item)) return false;
        const Primitive p = geometry.primitives[item];
        return p.kind == kind_of<Plane>() && has_packet_kernel(p);
    });
}

}  // namespace

Intersector::Intersector(const Geometry& geometry, SceneBounds bounds)
    : geometry_(geometry),
      bounds_(std::move(bounds)),
      has_only_planes_(are_planes(geometry, bounds_.unbounded)) {}

std::vector<ObjectSpace> Intersector::object_spaces() const {
    std::vector<ObjectSpace> spaces;
    spaces.reserve(objects_.size());
    for (const auto& object : objects_) spaces.emplace_back(object->bounds_);
    return spaces;
}

std::size_t Intersector::memory_bytes() const {
    std::size_t bytes = own_bytes();
    for (const auto& object : objects_) bytes += object->memory_bytes();
    return bytes;
}

void Intersector::offer_instance(std::uint32_t item, const RayQuery& query, NearestHit& nearest,
                                 TraversalCost* cost) const {
    const InstanceAt instance(geometry_, geometry_.instance_number(item), query.ray.time());
    Ray ray = to_object(*instance, query.ray);
    const Intersector& object = *objects_[instance->object];
    const bool misses = misses_bounds(object.bounds_.space, ray);
    if (misses && object.bounds_.unbounded.empty()) return;
    ray.tmax = nearest.t;
    const NearestHit hit = object.nearest_hit(ray, misses, cost);
    if (hit.found()) nearest.offer(hit.t, item, hit.item);
}

bool Intersector::instance_occludes(std::uint32_t item, const RayQuery& query) const {
    const InstanceAt instance(geometry_, geometry_.instance_number(item), query.ray.time());
    const Ray ray = to_object(*instance, query.ray);
    const Intersector& object = *objects_[instance->object];
    const bool misses = misses_bounds(object.bounds_.space, ray);
    return !(misses && object.bounds_.unbounded.empty()) && object.is_occluded(ray, misses);
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

inline void Intersector::offer(std::uint32_t item, const RayQuery& query, NearestHit& nearest,
                               TraversalCost* cost) const {
    if (geometry_.is_instance(item)) return offer_instance(item, query, nearest, cost);
    nearest.offer(primitive_first_hit(geometry_, item, query), item);
}

inline bool Intersector::occludes(std::uint32_t item, const RayQuery& query) const {
    if (geometry_.is_instance(item)) return instance_occludes(item, query);
    return primitive_first_hit(geometry_, item, query) <= query.ray.tmax;
}

NearestHit Intersector::nearest_unresolved(const Ray& ray, TraversalCost* cost) const {
    NearestHit nearest(ray.tmax);
    const RayQuery query(ray);
    if (bounds_.space.surely_misses(ray)) {
        for (const std::uint32_t item : bounds_.unbounded) offer(item, query, nearest, cost);
        if (cost != nullptr) cost->primitive_tests += bounds_.unbounded.size();
        return nearest;
    }
    if (cost != nullptr) cost->primitive_tests += geometry_.item_count();
    for (std::uint32_t item = 0; item < geometry_.item_count(); ++item) {
        offer(item, query, nearest, cost);
    }
    return nearest;
}

NearestHit Intersector::nearest_hit(const Ray& ray, bool misses, TraversalCost* cost) const {
    NearestHit nearest(ray.tmax);
    if (!is_valid(ray)) return nearest;
    if (has_extreme_direction(ray)) {
        const RescaledRay usual(ray);
        nearest = nearest_hit(usual.ray, cost);
        nearest.t *= usual.unit;
        return nearest;
    }
    if (!is_resolved(bounds_.space, ray)) return nearest_unresolved(ray, cost);
    const auto local = misses ? std::nullopt : normalized_ray(bounds_.space, ray);
    if (!local && bounds_.unbounded.empty()) return nearest;
    const RayQuery query(ray);
    for (const std::uint32_t item : bounds_.unbounded) offer(item, query, nearest, cost);
    if (cost != nullptr) cost->primitive_tests += bounds_.unbounded.size();
    if (!local) return nearest;
    if (cost != nullptr) {
        closest_counted(query, *local, nearest, *cost);
    } else {
        closest_bounded(query, *local, nearest);
    }
    return nearest;
}

bool Intersector::is_occluded_unresolved(const Ray& ray) const {
    const RayQuery query(ray);
    const auto blocks = [&](std::uint32_t item) { return occludes(item, query); };
    if (bounds_.space.surely_misses(ray)) return std::ranges::any_of(bounds_.unbounded, blocks);
    for (std::uint32_t item = 0; item < geometry_.item_count(); ++item) {
        if (blocks(item)) return true;
    }
    return false;
}

bool Intersector::is_occluded(const Ray& ray, bool misses) const {
    if (!is_valid(ray)) return false;
    if (has_extreme_direction(ray)) return is_occluded(RescaledRay(ray).ray);
    if (!is_resolved(bounds_.space, ray)) return is_occluded_unresolved(ray);
    const auto local = misses ? std::nullopt : normalized_ray(bounds_.space, ray);
    if (!local && bounds_.unbounded.empty()) return false;
    const RayQuery query(ray);
    for (const std::uint32_t item : bounds_.unbounded) {
        if (occludes(item, query)) return true;
    }
    return local && occluded_bounded(query, *local);
}

template <class Answer, class AnswerAlone, class AnswerLocal>
void Intersector::answer_all(std::span<const Ray> rays, std::span<Answer> answers,
                             const AnswerAlone& alone, const AnswerLocal& local) const {
    const DenormalsCount denormals_count;
    LocalRays local_rays;
    RayPacket planes;
    while (!rays.empty()) {
        const std::size_t count = std::min(LocalRays::most, rays.size());
        const RayColumns columns(rays.first(count));
        local_rays.set(bounds_.space, columns);
        const bool offers_planes = has_only_planes_ && columns.are_common();
        if (offers_planes) {
            planes.set(0, rays.first(count), columns);
            for (const std::uint32_t item : bounds_.unbounded)
                offer_to_packet(geometry_, item, planes);
        }
        const Chunk chunk{local_rays, offers_planes ? &planes : nullptr};
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_alone = local_rays.kind(i) == LocalRays::Kind::slow_path;
            answers[i] = is_alone ? alone(rays[i]) : local(rays[i], chunk, i);
        }
        rays = rays.subspan(count);
        answers = answers.subspan(count);
    }
}

/// Returns the nearest hit on an unbounded primitive, for ray number i of a chunk.
NearestHit Intersector::nearest_unbounded(const RayQuery& query, const Chunk& chunk,
                                          std::size_t i) const {
    NearestHit nearest(query.ray.tmax);
    if (chunk.planes == nullptr) {
        for (const std::uint32_t item : bounds_.unbounded) offer(item, query, nearest, nullptr);
    } else {
        const Hit hit = chunk.planes->hit(i);
        nearest.t = hit.t;
        nearest.item = hit.primitive;
    }
    return nearest;
}

Hit Intersector::closest_local(const Ray& ray, const Chunk& chunk, std::size_t i) const {
    const bool enters = chunk.rays.kind(i) == LocalRays::Kind::enters;
    if (!enters && bounds_.unbounded.empty()) return hit_of(NearestHit(ray.tmax));
    const RayQuery query(ray, chunk.rays.dominant(i));
    NearestHit nearest = nearest_unbounded(query, chunk, i);
    if (enters) closest_bounded(query, chunk.rays.ray(i), nearest);
    return hit_of(nearest);
}

bool Intersector::is_occluded_local(const Ray& ray, const Chunk& chunk, std::size_t i) const {
    const bool enters = chunk.rays.kind(i) == LocalRays::Kind::enters;
    if (chunk.planes != nullptr && chunk.planes->hit(i).primitive != no_index) return true;
    const bool tests_unbounded = chunk.planes == nullptr && !bounds_.unbounded.empty();
    if (!enters && !tests_unbounded) return false;
    const RayQuery query(ray, chunk.rays.dominant(i));
    const auto blocks = [&](std::uint32_t item) { return occludes(item, query); };
    if (tests_unbounded && std::ranges::any_of(bounds_.unbounded, blocks)) return true;
    return enters && occluded_bounded(query, chunk.rays.ray(i));
}

void Intersector::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    const auto alone = [&](const Ray& ray) { return hit_of(nearest_hit(ray)); };
    answer_all(rays, hits, alone, [&](const Ray& ray, const Chunk& chunk, std::size_t i) {
        return closest_local(ray, chunk, i);
    });
}

void Intersector::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    const auto alone = [&](const Ray& ray) -> std::uint8_t { return is_occluded(ray) ? 1 : 0; };
    answer_all(rays, blocked, alone,
               [&](const Ray& ray, const Chunk& chunk, std::size_t i) -> std::uint8_t {
                   return is_occluded_local(ray, chunk, i) ? 1 : 0;
               });
}

namespace {

std::optional<Hit> found(const Hit& hit) {
    return hit.primitive == no_index ? std::nullopt : std::optional(hit);
}

}  // namespace

std::optional<Hit> Intersector::closest(const Ray& ray) const {
    const DenormalsCount denormals_count;
    return found(hit_of(nearest_hit(ray)));
}

std::optional<Hit> Intersector::closest(const Ray& ray, TraversalCost& cost) const {
    const DenormalsCount denormals_count;
    return found(hit_of(nearest_hit(ray, &cost)));
}

bool Intersector::occluded(const Ray& ray) const {
    const DenormalsCount denormals_count;
    return is_occluded(ray);
}

}  // namespace etalon
