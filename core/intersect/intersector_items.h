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

}  // namespace etalon
