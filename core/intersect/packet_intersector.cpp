#include "core/intersect/packet_intersector.h"

#include <algorithm>
#include <array>

#include "core/intersect/packet_kernels.h"
#include "core/intersect/ray_packets.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Number of rays at the start of a batch that stand for the rest: if packets are of no use to
/// them, no further packet is tried.
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

/// Answers queries for the nearest hits.
class PacketIntersector::Closest {
  public:
    explicit Closest(const PacketIntersector& all) : all_(all) {}

    /// Answers for a packet if its rays may hit few primitives; the packet is empty then.
    void answer(RayPacket& packet, std::span<Hit> hits) {
        NearPrimitives::Numbers numbers;
        const auto near = all_.near_.find(packet, numbers);
        if (!near || !all_.near_.are_few(*near, packet)) return;
        for (const std::uint32_t primitive : *near) {
            offer_to_packet(all_.geometry_, primitive, packet);
        }
        for (std::size_t i = 0; i < packet.count; ++i) hits[packet.numbers[i]] = packet.hit(i);
        packet.count = 0;
    }

    /// Asks the backend, for a span or a stream of rays.
    template <class Rays>
    void ask(const Rays& rays, std::span<Hit> hits) const {
        all_.backend_.closest(rays, hits);
    }

  private:
    const PacketIntersector& all_;
};

/// Answers queries for occlusion. Most rays that are occluded are so by the primitive that occludes
/// others near them, which is therefore tested first.
class PacketIntersector::Occluded {
  public:
    explicit Occluded(const PacketIntersector& all) : all_(all) {}

    /// Removes rays from a packet whose answers are known: all if they may hit few primitives, else
    /// those that the primitives found to occlude some of them occlude. `blocked` is 0 before.
    void answer(RayPacket& packet, std::span<std::uint8_t> blocked) {
        NearPrimitives::Numbers numbers;
        auto near = all_.near_.find(packet, numbers);
        if (!near) return;
        const bool are_few = all_.near_.are_few(*near, packet);
        const auto last = std::ranges::find(*near, last_occluder_);
        if (last != near->end()) {
            offer(*last, packet, blocked);
            *last = near->back();
            near = near->first(near->size() - 1);
        }
        if (!are_few) return remove_occluded(packet, blocked);
        for (const std::uint32_t primitive : *near) {
            if (packet.count != 0) offer(primitive, packet, blocked);
        }
        packet.count = 0;
    }

    /// Asks the backend, for a span or a stream of rays.
    template <class Rays>
    void ask(const Rays& rays, std::span<std::uint8_t> blocked) const {
        all_.backend_.occluded(rays, blocked);
    }

  private:
    /// Removes the rays that a primitive occludes.
    void offer(std::uint32_t primitive, RayPacket& packet, std::span<std::uint8_t> blocked) {
        if (!offer_to_packet(all_.geometry_, primitive, packet)) return;
        packet.remove_hit([&](std::uint32_t number) { blocked[number] = 1; });
        last_occluder_ = primitive;
    }

    /// Removes the rays that are occluded by what occludes the packet's first ray, as long as that
    /// is worth it.
    void remove_occluded(RayPacket& packet, std::span<std::uint8_t> blocked) {
        constexpr std::size_t least_rays = 8, least_share = 8;  // one ray in so many
        for (bool helps = true; helps && packet.count >= least_rays;) {
            const std::size_t before = packet.count;
            const Ray ray = packet.ray(0);
            Hit hit;
            all_.backend_.closest({&ray, 1}, {&hit, 1});
            if (hit.primitive == no_index) return;
            offer(hit.primitive, packet, blocked);
            helps = least_share * (before - packet.count) >= before;
        }
    }

    const PacketIntersector& all_;
    std::uint32_t last_occluder_ = no_index;
};

PacketIntersector::PacketIntersector(const Geometry& geometry, const BatchIntersector& backend,
                                     bool is_exact)
    : geometry_(geometry),
      backend_(backend),
      has_packets_(is_exact && geometry.instances.empty() &&
                   geometry.primitives.size() <= NearPrimitives::most) {
    if (has_packets_) near_ = NearPrimitives(geometry);
}

/// Sets the answers packet by packet: by query.answer() as far as it goes, the rest by query.ask().
template <class Rays, class Answer, class Query>
void PacketIntersector::answer_all(const Rays& rays, std::span<Answer> answers, Query query) const {
    const DenormalsCount denormals_count;
    const auto ask = [&](auto some, auto to) { query.ask(some, to); };
    bool any_answered = false;
    for (std::size_t first = 0; first < rays.size(); first += RayPacket::most) {
        if (first == probed && !any_answered) {
            return ask(rays.subspan(first), answers.subspan(first));
        }
        const std::size_t count = std::min(RayPacket::most, rays.size() - first);
        const Rays chunk = rays.subspan(first, count);
        const auto answers_of_chunk = answers.subspan(first, count);
        const auto visit = [&](RayPacket& packet) {
            const std::size_t before = packet.count;
            query.answer(packet, answers_of_chunk);
            any_answered |= packet.count < before;
            if (packet.count != 0) ask_for_packet(packet, chunk, answers_of_chunk, ask);
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
    answer_all(rays, hits, Closest(*this));
}

template <class Rays>
void PacketIntersector::find_occluded(const Rays& rays, std::span<std::uint8_t> blocked) const {
    if (!has_packets_) return backend_.occluded(rays, blocked);
    std::ranges::fill(blocked, std::uint8_t{0});
    answer_all(rays, blocked, Occluded(*this));
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
