#include "native_accel/bvh/bvh.h"

#include "core/intersect/kernels.h"
#include "native_accel/bvh/traversal.h"

namespace etalon {

Bvh::Bvh(const Scene& scene) : Intersector(scene) {
    BvhTree tree = build_bvh(take_bounded());
    nodes_ = widen(tree.nodes);
    ids_ = std::move(tree.ids);
}

std::size_t Bvh::memory_bytes() const {
    return nodes_.capacity() * sizeof(WideNode) + ids_.capacity() * sizeof(std::uint32_t);
}

void Bvh::closest_bounded(const RayQuery& query, const FrameRay& local, NearestHit& nearest) const {
    if (nodes_.empty()) return;
    traverse(nodes_, local, local.tmin(query.ray.tmin), local.tmax(nearest.t),
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count; ++i) {
                     const std::uint32_t id = ids_[i];
                     nearest.offer(primitive_first_hit(scene(), id, query), id);
                 }
                 return local.tmax(nearest.t);
             });
}

bool Bvh::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    if (nodes_.empty()) return false;
    bool found = false;
    const float tmax = local.tmax(query.ray.tmax);
    traverse(nodes_, local, local.tmin(query.ray.tmin), tmax,
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count && !found; ++i) {
                     found = primitive_first_hit(scene(), ids_[i], query) <= query.ray.tmax;
                 }
                 return found ? -std::numeric_limits<float>::infinity() : tmax;
             });
    return found;
}

}  // namespace etalon
