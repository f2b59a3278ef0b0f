#include "core/intersect/near_primitives.h"

#include "core/intersect/kernels.h"
#include "core/intersect/packet_bounds.h"
#include "core/intersect/packet_kernels.h"

namespace etalon {
namespace {

/// Returns the cost of testing a packet against a primitive. Triangles cost more than others with a
/// packet kernel, since a tree tests eight of them at once; polygons, since all edges are tested.
std::uint8_t cost_of(const Primitive& primitive) {
    constexpr std::uint8_t one_by_one = 40, polygon = 8, triangle = 5, other = 4;
    if (!has_packet_kernel(primitive)) return one_by_one;
    if (primitive.kind == kind_of<Polygon>()) return polygon;
    return primitive.kind == kind_of<Triangle>() ? triangle : other;
}

/// Returns whether tests of that cost take less time than the traversal of a tree by each ray. The
/// fewer rays share the tests, the lower the cost must be.
bool is_worthwhile(std::size_t cost, std::size_t rays) {
    return cost <= 4 + 4 * rays / 3;
}

/// Returns whether most rays of a packet leave a primitive, which they exclude then.
bool is_left(const RayPacket& packet, std::uint32_t primitive) {
    return packet.excludes[0] == primitive && packet.excludes[packet.count - 1] == primitive;
}

}  // namespace

NearPrimitives::NearPrimitives(const Geometry& geometry) {
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        costs_.push_back(cost_of(geometry.primitives[id]));
        const Box3 box = whole_bounds(geometry, id);
        if (box.isEmpty()) continue;
        boxes_.add(box);
        primitives_.push_back(id);
    }
}

std::optional<std::span<std::uint32_t>> NearPrimitives::find(const RayPacket& packet,
                                                             Numbers& numbers) const {
    const PacketBounds bounds(packet);
    if (!bounds.goes_one_way()) return std::nullopt;
    const auto found = std::span(numbers).first(bounds.find_near(boxes_, numbers.data()));
    for (std::uint32_t& number : found) number = primitives_[number];
    return found;
}

bool NearPrimitives::are_few(std::span<const std::uint32_t> primitives,
                             const RayPacket& packet) const {
    std::size_t cost = 0;
    for (const std::uint32_t primitive : primitives) {
        if (!is_left(packet, primitive)) cost += costs_[primitive];
    }
    return is_worthwhile(cost, packet.count);
}

}  // namespace etalon
