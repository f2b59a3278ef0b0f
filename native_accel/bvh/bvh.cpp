#include "native_accel/bvh/bvh.h"

#include "core/intersect/kernels.h"
#include "native_accel/bvh/traversal.h"

namespace etalon {
namespace {

/// Where most primitives are triangles, leaves of as many as pays when four cost as much as one.
BvhConfig config_for(const Scene& scene) {
    BvhConfig config;
    if (2 * scene.all<Triangle>().size() < scene.primitives.size()) return config;
    config.lanes = TriangleLeaf::lanes;
    config.traversal_cost = 1.5F;
    return config;
}

}  // namespace

Bvh::Bvh(const Scene& scene) : Intersector(scene) {
    BvhTree tree = build_bvh(take_bounded(), config_for(scene));
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
