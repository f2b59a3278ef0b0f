#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/intersect/ray_group.h"

namespace etalon {

namespace detail {

/// Whether all rays are common ones of the same dominant axis, as nearly all neighbours are.
inline bool are_alike(const RayColumns& rays) {
    std::uint64_t common = ~std::uint64_t{0}, differences = 0;
    for (std::size_t i = 0; i < rays.count; ++i) {
        common &= rays.common[i];
        differences |= rays.dominants[i] ^ rays.dominants[0];
    }
    return common != 0 && differences == 0;
}

/// Adds the rays to the groups of their dominant axes; those that can hit nothing to none.
inline void sort_into(std::array<RayGroup, 3>& groups, std::span<const Ray> rays,
                      const RayColumns& columns) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (columns.common[i] != 0) {
            groups[columns.dominants[i]].add(rays[i], rays[i].direction);
        } else if (is_valid(rays[i])) {
            const RayQuery query(rays[i]);
            groups[query.kz].add(rays[i], query.ray.direction);
        }
    }
}

}  // namespace detail

/// Calls visit(group) for all rays that can hit anything, neighbours of one dominant axis together;
/// a group is for visit() to change. Their numbers are those in `rays`.
template <class Visit>
void for_each_group(std::span<const Ray> rays, const Visit& visit) {
    std::array<RayGroup, 3> groups;
    for (int axis = 0; axis < 3; ++axis) groups[axis].dominant = axis;
    while (!rays.empty()) {
        const auto chunk = rays.first(std::min(RayColumns::most, rays.size()));
        rays = rays.subspan(chunk.size());
        const RayColumns columns(chunk);
        if (detail::are_alike(columns)) {
            RayGroup& group = groups[columns.dominants[0]];
            group.set(chunk, columns);
            visit(group);
            group.count = 0;
            continue;
        }
        detail::sort_into(groups, chunk, columns);
        for (RayGroup& group : groups) {
            if (group.count != 0) visit(group);
            group.count = 0;
        }
    }
}

}  // namespace etalon
