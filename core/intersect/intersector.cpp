#include "core/intersect/intersector.h"

#include <algorithm>

#include "core/intersect/kernels.h"
#include "core/intersect/local_rays.h"
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

template <class Answer, class AnswerAlone, class AnswerLocal>
void Intersector::answer_all(std::span<const Ray> rays, std::span<Answer> answers,
                             const AnswerAlone& alone, const AnswerLocal& local) const {
    const DenormalsCount denormals_count;
    LocalRays chunk;
    while (!rays.empty()) {
        const std::size_t count = std::min(LocalRays::most, rays.size());
        chunk.set(bounds_.space, rays.first(count));
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_alone = chunk.way(i) == LocalRays::Way::by_itself;
            answers[i] = is_alone ? alone(rays[i]) : local(rays[i], chunk, i);
        }
        rays = rays.subspan(count);
        answers = answers.subspan(count);
    }
}

Hit Intersector::closest_local(const Ray& ray, const LocalRays& chunk, std::size_t i) const {
    NearestHit nearest(ray.tmax);
    const bool enters = chunk.way(i) == LocalRays::Way::enters;
    if (enters || !bounds_.unbounded.empty()) {
        const RayQuery query(ray, chunk.dominant(i));
        for (const std::uint32_t id : bounds_.unbounded) {
            nearest.offer(primitive_first_hit(geometry_, id, query), id);
        }
        if (enters) closest_bounded(query, chunk.ray(i), nearest);
    }
    return {nearest.t, nearest.primitive};
}

bool Intersector::is_occluded_local(const Ray& ray, const LocalRays& chunk, std::size_t i) const {
    const bool enters = chunk.way(i) == LocalRays::Way::enters;
    if (!enters && bounds_.unbounded.empty()) return false;
    const RayQuery query(ray, chunk.dominant(i));
    for (const std::uint32_t id : bounds_.unbounded) {
        if (reaches(geometry_, id, query)) return true;
    }
    return enters && occluded_bounded(query, chunk.ray(i));
}

void Intersector::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    const auto alone = [&](const Ray& ray) {
        const NearestHit nearest = nearest_hit(ray);
        return Hit{nearest.t, nearest.primitive};
    };
    answer_all(rays, hits, alone, [&](const Ray& ray, const LocalRays& chunk, std::size_t i) {
        return closest_local(ray, chunk, i);
    });
}

void Intersector::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    const auto alone = [&](const Ray& ray) -> std::uint8_t { return is_occluded(ray) ? 1 : 0; };
    answer_all(rays, blocked, alone,
               [&](const Ray& ray, const LocalRays& chunk, std::size_t i) -> std::uint8_t {
                   return is_occluded_local(ray, chunk, i) ? 1 : 0;
               });
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
