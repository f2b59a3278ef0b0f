#pragma once

#include "core/intersect/ray_packet.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Offers a primitive to the rays of a packet: what primitive_first_hit() gives for each, to the
/// bit, several rays at a time where the shape has a kernel for that. Returns whether it is now the
/// nearest hit of any.
bool offer_to_packet(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet);

/// Whether several rays are tested at a time; else one after another.
bool has_packet_kernel(const Primitive& primitive);

}  // namespace etalon
