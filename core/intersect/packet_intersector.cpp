#include "core/intersect/packet_intersector.h"

#include <algorithm>
#include <array>

#include "core/intersect/kernels.h"
#include "core/intersect/packet_kernels.h"
#include "core/intersect/ray_packets.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Returns the cost of testing a packet against a primitive. Triangles cost more than others with a
/// packet kernel, since a tree tests eight of them at once.
std::uint8_t cost_of(const Geometry& geometry, const Primitive& primitive) {
    constexpr std::uint8_t one_by_one = 16, triangle = 5, other = 4;
    if (!has_packet_kernel(geometry, primitive)) return one_by_one;
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

/// Number of rays at the start of a batch that stand for the rest: if each of their packets may hit
/// too many primitives, no further packet is tried.
constexpr std::size_t probed = 2 * RayPacket::most;

/// Calls ask(rays, answers), which asks the backend, for those of `rays` that are in the packet.
template <class Rays, class Answer, class Ask>
void ask_for_packet(const RayPacket& packet, const Rays& rays, std::span<Answer> answers,
                    const Ask& ask) {
    if (packet.count == rays.size()) return ask(rays, answers);
    std::array<Ray, RayPacket::most> some;
    std::array<Answer, RayPacket::most> found;
    for (std::size_t i = 0; i < packet.count; ++i) some[i] = rays[packet.numbers[i]];
    ask(std::span<const Ray>(some).first(packet.count), std::span(found).first(packet.count));
    for (std::size_t i = 0; i < packet.count; ++i) answers[packet.numbers[i]] = found[i];
}

}  // namespace

PacketIntersector::PacketIntersector(const Geometry& geometry, const BatchIntersector& backend,
                                     bool is_exact)
    : geometry_(geometry),
      backend_(backend),
      has_packets_(is_exact && geometry.instances.empty() &&
                   geometry.primitives.size() <= most_primitives) {
    if (!has_packets_) return;
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        const Box3 box = whole_bounds(geometry, id);
        if (box.isEmpty()) continue;
        boxes_.add(box);
        primitives_.push_back(id);
        costs_.push_back(cost_of(geometry, geometry.primitives[id]));
    }
}

/// Finds the primitives that rays of a packet may hit. Returns nothing if they are too many.
std::optional<std::span<const std::uint32_t>> PacketIntersector::find_few(const RayPacket& packet,
                                                                          Near& near) const {
    const PacketBounds bounds(packet);
    if (!bounds.goes_one_way()) return std::nullopt;
    const auto found = std::span(near).first(bounds.find_near(boxes_, near.data()));
    std::size_t cost = 0;
    for (const std::uint32_t i : found) {
        if (!is_left(packet, primitives_[i])) cost += costs_[i];
    }
    if (!is_worthwhile(cost, packet.count)) return std::nullopt;
    return found;
}

/// Sets the answers packet by packet: by offer(packet, near) if its rays may hit few primitives,
/// else by ask(rays, answers), which asks the backend.
template <class Rays, class Answer, class Offer, class Ask>
void PacketIntersector::answer_all(const Rays& rays, std::span<Answer> answers, const Offer& offer,
                                   const Ask& ask) const {
    const DenormalsCount denormals_count;
    bool any_few = false;
    for (std::size_t first = 0; first < rays.size(); first += RayPacket::most) {
        if (first == probed && !any_few) return ask(rays.subspan(first), answers.subspan(first));
        const std::size_t count = std::min(RayPacket::most, rays.size() - first);
        const Rays chunk = rays.subspan(first, count);
        const auto answers_of_chunk = answers.subspan(first, count);
        const auto visit = [&](RayPacket& packet) {
            Near near;
            if (const auto few = find_few(packet, near)) {
                offer(packet, *few, answers_of_chunk);
                any_few = true;
            } else {
                ask_for_packet(packet, chunk, answers_of_chunk, ask);
            }
        };
        for_each_packet(chunk, visit, [&](std::size_t i) {
            ask(chunk.subspan(i, 1), answers_of_chunk.subspan(i, 1));
        });
    }
}

/// All rays of a batch have the same coherence hint. Shadow rays need none: those of adjacent rays
/// mostly go to the same lights.
template <class Rays>
void PacketIntersector::find_closest(const Rays& rays, std::span<Hit> hits) const {
    if (!has_packets_ || rays.empty() || !rays[0].coherent()) return backend_.closest(rays, hits);
    std::ranges::fill(hits, Hit{infinity, no_index});
    const auto offer = [&](RayPacket& packet, std::span<const std::uint32_t> near,
                           std::span<Hit> to) {
        for (const std::uint32_t i : near) offer_to_packet(geometry_, primitives_[i], packet);
        for (std::size_t i = 0; i < packet.count; ++i) to[packet.numbers[i]] = packet.hit(i);
    };
    answer_all(rays, hits, offer, [&](auto some, auto to) { backend_.closest(some, to); });
}

template <class Rays>
void PacketIntersector::find_occluded(const Rays& rays, std::span<std::uint8_t> blocked) const {
    if (!has_packets_) return backend_.occluded(rays, blocked);
    std::ranges::fill(blocked, std::uint8_t{0});
    const auto offer = [&](RayPacket& packet, std::span<const std::uint32_t> near,
                           std::span<std::uint8_t> to) {
        for (const std::uint32_t i : near) {
            if (!offer_to_packet(geometry_, primitives_[i], packet)) continue;
            packet.remove_hit([&](std::uint32_t number) { to[number] = 1; });
        }
    };
    answer_all(rays, blocked, offer, [&](auto some, auto to) { backend_.occluded(some, to); });
}

void PacketIntersector::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    find_closest(rays, hits);
}

void PacketIntersector::closest(const RayStream& rays, std::span<Hit> hits) const {
    find_closest(rays, hits);
}

void PacketIntersector::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    find_occluded(rays, blocked);
}

void PacketIntersector::occluded(const RayStream& rays, std::span<std::uint8_t> blocked) const {
    find_occluded(rays, blocked);
}

}  // namespace etalon
