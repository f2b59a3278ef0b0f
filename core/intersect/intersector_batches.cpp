// Hits of batches of rays, which share what their chunks have for them.
#include <algorithm>

#include "core/intersect/intersector_items.h"
#include "core/intersect/local_rays.h"
#include "core/intersect/packet_kernels.h"
#include "core/numerics/denormals.h"

namespace etalon {

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
        offer_unbounded(query, nearest, nullptr);
    } else {
        const Hit hit = chunk.planes->hit(i);
        nearest.t = hit.t;
        nearest.item = hit.primitive;
    }
    return nearest;
}

Hit Intersector::closest_local(const Ray& ray, const Chunk& chunk, std::size_t i) const {
    const bool enters = chunk.rays.kind(i) == LocalRays::Kind::enters;
    if (!enters && !bounds_.has_more()) return hit_of(NearestHit(ray.tmax));
    const RayQuery query(ray, chunk.rays.dominant(i));
    NearestHit nearest = nearest_unbounded(query, chunk, i);
    if (enters) closest_bounded(query, chunk.rays.ray(i), nearest);
    return hit_of(nearest);
}

bool Intersector::is_occluded_local(const Ray& ray, const Chunk& chunk, std::size_t i) const {
    const bool enters = chunk.rays.kind(i) == LocalRays::Kind::enters;
    if (chunk.planes != nullptr && chunk.planes->hit(i).primitive != no_index) return true;
    const bool tests_unbounded = chunk.planes == nullptr && bounds_.has_more();
    if (!enters && !tests_unbounded) return false;
    const RayQuery query(ray, chunk.rays.dominant(i));
    if (tests_unbounded && unbounded_occludes(query)) return true;
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

}  // namespace etalon
