#include "native_accel/bvh/bvh.h"

#include "core/intersect/kernels.h"
#include "native_accel/bvh/scene_tree.h"
#include "native_accel/bvh/traversal.h"

namespace etalon {
namespace {

/// What testing the leaves costs as they are now.
BvhConfig leaf_config() {
    BvhConfig config;
    config.leaf_costs[kind_of<Triangle>()] = {TriangleLeaf::lanes, 0.7F};
    config.leaf_costs[kind_of<Sphere>()] = {1, 1.0F};
    return config;
}

}  // namespace

Bvh::Bvh(const Scene& scene) : Intersector(scene) {
    BvhTree tree = build_scene_bvh(scene, scene_bounds().frame, take_bounded(), leaf_config());
    leaves_ = Leaves(scene, scene_bounds().frame, tree);
    nodes_ = widen(tree.nodes);
}

std::size_t Bvh::memory_bytes() const {
    return nodes_.capacity() * sizeof(WideNode) + leaves_.memory_bytes();
}

void Bvh::closest_bounded(const RayQuery& query, const FrameRay& local, NearestHit& nearest) const {
    if (nodes_.empty()) return;
    const TriangleFilter filter(local);
    const auto offer = [&](std::uint32_t id) {
        nearest.offer(primitive_first_hit(scene(), id, query), id);
        return true;
    };
    traverse(nodes_, local, local.tmin(query.ray.tmin), local.tmax(nearest.t),
             [&](std::uint32_t first, std::uint32_t count, float tmax) {
                 const double before = nearest.t;
                 leaves_.visit(first, count, filter, tmax, offer);
                 return nearest.t < before ? local.tmax(nearest.t) : tmax;
             });
}

bool Bvh::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    if (nodes_.empty()) return false;
    const TriangleFilter filter(local);
    bool found = false;
    const auto offer = [&](std::uint32_t id) {
        found = primitive_first_hit(scene(), id, query) <= query.ray.tmax;
        return !found;
    };
    traverse(nodes_, local, local.tmin(query.ray.tmin), local.tmax(query.ray.tmax),
             [&](std::uint32_t first, std::uint32_t count, float tmax) {
                 leaves_.visit(first, count, filter, tmax, offer);
                 return found ? -std::numeric_limits<float>::infinity() : tmax;
             });
    return found;
}

}  // namespace etalon
