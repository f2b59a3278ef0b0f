#include "native_accel/bvh/bvh.h"

#include "core/intersect/kernels.h"
#include "native_accel/bvh/traversal.h"

namespace etalon {

Bvh::Bvh(const Scene& scene) : Intersector(scene) { tree_ = build_bvh(take_bounded()); }

std::size_t Bvh::memory_bytes() const {
    return tree_.nodes.capacity() * sizeof(BvhNode) + tree_.ids.capacity() * sizeof(std::uint32_t);
}

void Bvh::closest_bounded(const RayQuery& query, const FrameRay& local, NearestHit& nearest) const {
    if (tree_.nodes.empty()) return;
    traverse(tree_, local, local.tmin(query.ray.tmin), local.tmax(nearest.t),
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count; ++i) {
                     const std::uint32_t id = tree_.ids[i];
                     nearest.offer(primitive_first_hit(scene(), id, query), id);
                 }
                 return local.tmax(nearest.t);
             });
}

bool Bvh::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    if (tree_.nodes.empty()) return false;
    bool found = false;
    const float tmax = local.tmax(query.ray.tmax);
    traverse(tree_, local, local.tmin(query.ray.tmin), tmax,
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count && !found; ++i) {
                     found = primitive_first_hit(scene(), tree_.ids[i], query) <= query.ray.tmax;
                 }
                 return found ? -std::numeric_limits<float>::infinity() : tmax;
             });
    return found;
}

}  // namespace etalon
