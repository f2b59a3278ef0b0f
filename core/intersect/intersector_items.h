// How an intersector tests one item, for its own files: every query calls these.
#pragma once

#include "core/intersect/intersector.h"
#include "core/intersect/kernels.h"

namespace etalon {

inline void Intersector::offer(std::uint32_t item, const RayQuery& query, NearestHit& nearest,
                               TraversalCost* cost) const {
    if (geometry_.is_instance(item)) return offer_instance(item, query, nearest, cost);
    nearest.offer(primitive_first_hit(geometry_, item, query), item);
}

inline bool Intersector::occludes(std::uint32_t item, const RayQuery& query) const {
    if (geometry_.is_instance(item)) return instance_occludes(item, query);
    return primitive_first_hit(geometry_, item, query) <= query.ray.tmax;
}

inline void Intersector::offer_unbounded(const RayQuery& query, NearestHit& nearest,
                                         TraversalCost* cost) const {
    for (const std::uint32_t item : bounds_.unbounded) offer(item, query, nearest, cost);
    std::size_t tests = bounds_.unbounded.size();
    if (far_) {
        far_->visit(query.ray, nearest.t, [&](std::uint32_t item) {
            ++tests;
            offer(item, query, nearest, cost);
            return true;
        });
    }
    if (cost != nullptr) cost->primitive_tests += tests;
}

inline bool Intersector::unbounded_occludes(const RayQuery& query) const {
    for (const std::uint32_t item : bounds_.unbounded) {
        if (occludes(item, query)) return true;
    }
    return far_ && !far_->visit(query.ray, query.ray.tmax,
                                [&](std::uint32_t item) { return !occludes(item, query); });
}

}  // namespace etalon
