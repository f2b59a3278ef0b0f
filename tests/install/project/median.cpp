#include "median.h"

#include <algorithm>
#include <cmath>

#include "core/intersect/kernels.h"

namespace laboratory {
namespace {

using namespace etalon;

constexpr std::size_t leaf_size = 4;

/// Returns whether a ray meets a box between tnear and tfar. A direction too small to divide by
/// rejects no box.
bool meets(const NormalizedRay& ray, const Box3f& box, float tnear, float tfar) {
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = 1 / ray.direction[axis];
        if (!std::isfinite(inverse)) continue;
        const float t0 = (box.min[axis] - ray.origin[axis]) * inverse;
        const float t1 = (box.max[axis] - ray.origin[axis]) * inverse;
        tnear = std::max(tnear, std::min(t0, t1));
        tfar = std::min(tfar, std::max(t0, t1));
    }
    return tnear <= tfar;
}

Box3f box_around(std::span<const BoundedPrimitive> primitives) {
    Box3f box;
    for (const BoundedPrimitive& primitive : primitives) box.extendBy(primitive.box());
    return box;
}

}  // namespace

Median::Median(const Geometry& geometry) : Intersector(geometry) {
    build_objects<Median>();
    std::vector<BoundedPrimitive> bounded = take_bounded();
    if (!bounded.empty()) build(bounded, 0);
    for (const BoundedPrimitive& primitive : bounded) primitives_.push_back(primitive.id);
}

std::size_t Median::own_bytes() const {
    return nodes_.size() * sizeof(Node) + primitives_.size() * sizeof(std::uint32_t);
}

void Median::build(std::span<BoundedPrimitive> primitives, std::uint32_t first) {
    const std::size_t self = nodes_.size();
    const auto count = static_cast<std::uint32_t>(primitives.size());
    const Box3f box = box_around(primitives);
    nodes_.push_back({box, first, count > leaf_size ? first : first + count, 0});
    if (count > leaf_size) {
        const auto half = count / 2;
        const auto axis = box.majorAxis();
        std::ranges::nth_element(primitives, primitives.begin() + half, {},
                                 [axis](const auto& p) { return p.min[axis] + p.max[axis]; });
        build(primitives.first(half), first);
        build(primitives.subspan(half), first + half);
    }
    nodes_[self].next = static_cast<std::uint32_t>(nodes_.size());
}

template <class Tmax, class Offer>
bool Median::traverse(const RayQuery& query, const NormalizedRay& local, const Tmax& tmax,
                      const Offer& offer) const {
    for (std::size_t i = 0; i < nodes_.size();) {
        const Node& node = nodes_[i];
        if (!meets(local, node.box, local.tmin(query.ray.tmin), local.tmax(tmax()))) {
            i = node.next;
            continue;
        }
        for (std::uint32_t p = node.begin; p < node.end; ++p) {
            if (offer(primitives_[p])) return true;
        }
        ++i;
    }
    return false;
}

void Median::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                             NearestHit& nearest) const {
    traverse(
        query, local, [&] { return nearest.t; },
        [&](std::uint32_t item) {
            if (geometry().is_instance(item)) {
                offer_instance(item, query, nearest);
            } else {
                nearest.offer(primitive_first_hit(geometry(), item, query), item);
            }
            return false;
        });
}

bool Median::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    return traverse(
        query, local, [&] { return query.ray.tmax; },
        [&](std::uint32_t item) {
            if (geometry().is_instance(item)) return instance_occludes(item, query);
            return primitive_first_hit(geometry(), item, query) <= query.ray.tmax;
        });
}

}  // namespace laboratory
