#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/intersect/ray_packet.h"
#include "core/intersect/rescaled_ray.h"

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

/// Adds the rays to the packets of their dominant axes, but for those of extreme directions, for
/// which it calls alone(ray), and those that can hit nothing.
template <class Alone>
void sort_into(std::array<RayPacket, 3>& packets, std::span<const Ray> rays,
               const RayColumns& columns, const Alone& alone) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (columns.common[i] != 0) {
            packets[columns.dominants[i]].add(rays[i], rays[i].direction);
        } else if (is_valid(rays[i]) && has_extreme_direction(rays[i])) {
            alone(rays[i]);
        } else if (is_valid(rays[i])) {
            const RayQuery query(rays[i]);
            packets[query.kz].add(rays[i], query.ray.direction);
        }
    }
}

}  // namespace detail

/// Calls visit(packet) for all rays that can hit anything, neighbours of one dominant axis
/// together; a packet is for visit() to change. Calls alone(ray) for rays of extreme directions:
/// see RescaledRay. Both get references to rays of the span.
template <class Visit, class Alone>
void for_each_packet(std::span<const Ray> rays, const Visit& visit, const Alone& alone) {
    std::array<RayPacket, 3> packets;
    for (int axis = 0; axis < 3; ++axis) packets[axis].dominant = axis;
    while (!rays.empty()) {
        const auto chunk = rays.first(std::min(RayColumns::most, rays.size()));
        rays = rays.subspan(chunk.size());
        const RayColumns columns(chunk);
        if (detail::are_alike(columns)) {
            RayPacket& packet = packets[columns.dominants[0]];
            packet.set(chunk, columns);
            visit(packet);
            packet.count = 0;
            continue;
        }
        detail::sort_into(packets, chunk, columns, alone);
        for (RayPacket& packet : packets) {
            if (packet.count != 0) visit(packet);
            packet.count = 0;
        }
    }
}

}  // namespace etalon
