#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/intersect/ray_packet.h"
#include "core/intersect/rescaled_ray.h"

namespace etalon {

namespace detail {

/// Adds the rays, numbered from `first` on, to the packets of their dominant axes. For rays of
/// extreme directions it calls alone(number) instead. Rays that cannot hit anything are left out.
template <class Rays, class Alone>
void sort_into(std::array<RayPacket, 3>& packets, std::size_t first, const Rays& rays,
               const RayColumns& columns, const Alone& alone) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];  // a stream returns a copy, whose lifetime is extended
        if (columns.common[i] != 0) {
            packets[columns.dominants[i]].add(first + i, ray, ray.direction);
        } else if (is_valid(ray) && has_extreme_direction(ray)) {
            alone(first + i);
        } else if (is_valid(ray)) {
            const RayQuery query(ray);
            packets[query.kz].add(first + i, ray, query.ray.direction);
        }
    }
}

}  // namespace detail

/// Calls visit(packet) for packets of all rays that can hit anything; adjacent rays of one dominant
/// axis share a packet, which visit() may change. Calls alone(number) for rays of extreme
/// directions: see RescaledRay. `rays` is a span or a stream.
template <class Rays, class Visit, class Alone>
void for_each_packet(const Rays& rays, const Visit& visit, const Alone& alone) {
    std::array<RayPacket, 3> packets;
    for (int axis = 0; axis < 3; ++axis) packets[axis].dominant = axis;
    for (std::size_t first = 0; first < rays.size(); first += RayColumns::most) {
        const Rays chunk = rays.subspan(first, std::min(RayColumns::most, rays.size() - first));
        const RayColumns columns(chunk);
        if (columns.are_alike) {
            RayPacket& packet = packets[columns.dominants[0]];
            packet.set(first, chunk, columns);
            visit(packet);
            packet.count = 0;
            continue;
        }
        detail::sort_into(packets, first, chunk, columns, alone);
        for (RayPacket& packet : packets) {
            if (packet.count != 0) visit(packet);
            packet.count = 0;
        }
    }
}

}  // namespace etalon
