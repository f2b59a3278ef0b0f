#include "native_accel/none.h"

#include <algorithm>

#include "core/intersect/packet_kernels.h"
#include "core/intersect/ray_packets.h"
#include "core/numerics/denormals.h"

namespace etalon {

None::None(const Geometry& geometry) : Intersector(geometry, SceneBounds::none_bounded(geometry)) {
    build_objects<None>();
}

/// Calls visit(item) for the instances, as long as it returns true. Returns whether it always did.
template <class Visit>
bool None::for_each_instance(const Visit& visit) const {
    const auto first = static_cast<std::uint32_t>(geometry().primitives.size());
    for (std::uint32_t item = first; item < geometry().item_count(); ++item) {
        if (!visit(item)) return false;
    }
    return true;
}

std::size_t None::own_bytes() const {
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t);
}

void None::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    const DenormalsCount denormals_count;
    constexpr Hit nothing{infinity, no_index};
    std::ranges::fill(hits, nothing);
    const auto trace = [&](RayPacket& packet) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            offer_to_packet(geometry(), id, packet);
        }
        const bool has_instances = !geometry().instances.empty();
        for (std::size_t i = 0; i < packet.count; ++i) {
            const Hit hit = packet.hit(i);
            hits[packet.numbers[i]] =
                has_instances ? with_instances(rays[packet.numbers[i]], hit) : hit;
        }
    };
    for_each_packet(rays, trace, [&](std::size_t number) {
        hits[number] = closest(rays[number]).value_or(nothing);
    });
}

/// Returns the nearer of the nearest hit on a primitive, `hit`, and the hits on instances.
Hit None::with_instances(const Ray& ray, const Hit& hit) const {
    const RayQuery query(ray);
    NearestHit nearest(hit.t);
    nearest.item = hit.primitive;
    for_each_instance([&](std::uint32_t item) {
        offer_instance(item, query, nearest);
        return true;
    });
    return hit_of(nearest);
}

bool None::instances_occlude(const Ray& ray) const {
    const RayQuery query(ray);
    return !for_each_instance([&](std::uint32_t item) { return !instance_occludes(item, query); });
}

void None::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    const DenormalsCount denormals_count;
    std::ranges::fill(blocked, std::uint8_t{0});
    const auto trace = [&](RayPacket& packet) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            if (!offer_to_packet(geometry(), id, packet)) continue;
            packet.remove_hit([&](std::uint32_t number) { blocked[number] = 1; });
        }
        if (geometry().instances.empty()) return;
        for (std::size_t i = 0; i < packet.count; ++i) {
            const std::uint32_t number = packet.numbers[i];
            blocked[number] = instances_occlude(rays[number]) ? 1 : 0;
        }
    };
    for_each_packet(rays, trace,
                    [&](std::size_t number) { blocked[number] = occluded(rays[number]) ? 1 : 0; });
}

}  // namespace etalon
