#pragma once

#include "core/intersect/ray_packet.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Intersects the rays of a packet with a primitive and updates their nearest hits. The bits are
/// those of primitive_first_hit(); several rays are tested at a time where the shape has a packet
/// kernel. Returns whether the primitive is now the nearest hit of any ray.
bool offer_to_packet(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet);

/// Returns whether several rays are tested at a time, not one after another.
bool has_packet_kernel(const Primitive& primitive);

}  // namespace etalon
