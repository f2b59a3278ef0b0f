#include "core/intersect/intersector.h"

#include "core/intersect/kernels.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

bool reaches(const Geometry& geometry, std::uint32_t id, const RayQuery& query) {
    return primitive_first_hit(geometry, id, query) <= query.ray.tmax;
}

}  // namespace

Intersector::Intersector(const Geometry& geometry, SceneBounds bounds)
    : geometry_(geometry), bounds_(std::move(bounds)) {}

template <class OfferBounded>
NearestHit Intersector::closest_of_all(const Ray& ray, const OfferBounded& offer_bounded) const {
    NearestHit nearest(ray.tmax);
    if (!is_valid(ray)) return nearest;
    const RayQuery query(ray);
    if (!bounds_.space.resolves(ray)) {
        for (std::uint32_t id = 0; id < geometry_.primitives.size(); ++id) {
            nearest.offer(primitive_first_hit(geometry_, id, query), id);
        }
        return nearest;
    }
    for (const std::uint32_t id : bounds_.unbounded) {
        nearest.offer(primitive_first_hit(geometry_, id, query), id);
    }
    if (const auto local = bounds_.space.ray(ray)) offer_bounded(query, *local, nearest);
    return nearest;
}

bool Intersector::is_occluded(const Ray& ray) const {
    if (!is_valid(ray)) return false;
    const RayQuery query(ray);
    if (!bounds_.space.resolves(ray)) {
        for (std::uint32_t id = 0; id < geometry_.primitives.size(); ++id) {
            if (reaches(geometry_, id, query)) return true;
        }
        return false;
    }
    for (const std::uint32_t id : bounds_.unbounded) {
        if (reaches(geometry_, id, query)) return true;
    }
    const auto local = bounds_.space.ray(ray);
    return local && occluded_bounded(query, *local);
}

NearestHit Intersector::nearest_hit(const Ray& ray) const {
    return closest_of_all(
        ray, [&](const RayQuery& query, const NormalizedRay& local, NearestHit& nearest) {
            closest_bounded(query, local, nearest);
        });
}

void Intersector::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    const DenormalsCount denormals_count;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const NearestHit nearest = nearest_hit(rays[i]);
        hits[i] = {nearest.t, nearest.primitive};
    }
}

void Intersector::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    const DenormalsCount denormals_count;
    for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = is_occluded(rays[i]) ? 1 : 0;
}

std::optional<Hit> Intersector::closest(const Ray& ray) const {
    const DenormalsCount denormals_count;
    return nearest_hit(ray).result();
}

std::optional<Hit> Intersector::closest(const Ray& ray, TraversalCost& cost) const {
    if (!is_valid(ray)) return std::nullopt;
    const DenormalsCount denormals_count;
    const bool resolved = bounds_.space.resolves(ray);
    cost.primitive_tests += resolved ? bounds_.unbounded.size() : geometry_.primitives.size();
    return closest_of_all(
               ray, [&](const RayQuery& query, const NormalizedRay& local,
                        NearestHit& nearest) { closest_counted(query, local, nearest, cost); })
        .result();
}

bool Intersector::occluded(const Ray& ray) const {
    const DenormalsCount denormals_count;
    return is_occluded(ray);
}

}  // namespace etalon
