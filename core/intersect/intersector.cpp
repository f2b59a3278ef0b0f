#include "core/intersect/intersector.h"

#include <algorithm>

#include "core/intersect/intersector_items.h"
#include "core/intersect/object_space.h"
#include "core/intersect/packet_kernels.h"
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

std::optional<Hit> found(const Hit& hit) {
    return hit.primitive == no_index ? std::nullopt : std::optional(hit);
}

}  // namespace

Intersector::Intersector(const Geometry& geometry, SceneBounds bounds)
    : geometry_(geometry),
      bounds_(std::move(bounds)),
      has_only_planes_(bounds_.far.empty() && are_planes(geometry, bounds_.unbounded)) {
    if (!bounds_.far.empty()) far_.emplace(geometry, bounds_.far);
}

std::vector<ObjectSpace> Intersector::object_spaces() const {
    std::vector<ObjectSpace> spaces;
    spaces.reserve(objects_.size());
    for (const auto& object : objects_) spaces.emplace_back(object->bounds_);
    return spaces;
}

std::size_t Intersector::memory_bytes() const {
    std::size_t bytes = own_bytes() + (far_ ? far_->memory_bytes() : 0);
    for (const auto& object : objects_) bytes += object->memory_bytes();
    return bytes;
}

NearestHit Intersector::nearest_unresolved(const Ray& ray, TraversalCost* cost) const {
    NearestHit nearest(ray.tmax);
    const RayQuery query(ray);
    if (bounds_.space.surely_misses(ray)) {
        offer_unbounded(query, nearest, cost);
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
    if (!local && !bounds_.has_more()) return nearest;
    const RayQuery query(ray);
    offer_unbounded(query, nearest, cost);
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
    if (bounds_.space.surely_misses(ray)) return unbounded_occludes(query);
    for (std::uint32_t item = 0; item < geometry_.item_count(); ++item) {
        if (occludes(item, query)) return true;
    }
    return false;
}

bool Intersector::is_occluded(const Ray& ray, bool misses) const {
    if (!is_valid(ray)) return false;
    if (has_extreme_direction(ray)) return is_occluded(RescaledRay(ray).ray);
    if (!is_resolved(bounds_.space, ray)) return is_occluded_unresolved(ray);
    const auto local = misses ? std::nullopt : normalized_ray(bounds_.space, ray);
    if (!local && !bounds_.has_more()) return false;
    const RayQuery query(ray);
    return unbounded_occludes(query) || (local && occluded_bounded(query, *local));
}

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
