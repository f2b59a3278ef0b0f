// Compares packet kernels with the kernels for single rays, for every instruction set that they are
// compiled for and this machine has.
#include "core/intersect/packet_kernels.h"

#include <bit>

#include "core/intersect/kernels.h"
#include "tests/each_instruction_set.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns the hit of the kernel for a single ray.
Hit hit_alone(const Geometry& geometry, const Ray& ray) {
    NearestHit nearest(ray.tmax);
    nearest.offer(primitive_first_hit(geometry, 0, RayQuery(ray)), 0);
    return {nearest.t, nearest.item};
}

bool same_bits(const Hit& a, const Hit& b) {
    return a.primitive == b.primitive &&
           std::bit_cast<std::uint64_t>(a.t) == std::bit_cast<std::uint64_t>(b.t);
}

/// Returns tmin and tmax of all kinds around a possible hit.
void limit(Ray& ray, const Hit& hit, int i) {
    if (i % 4 == 1) ray.tmin = hit.primitive == no_index ? 0.5 : hit.t;
    if (i % 4 == 2) ray.tmax = hit.primitive == no_index ? 2.0 : hit.t;
    if (i % 16 == 3) ray.exclude = 0;
}

void require_same(const Geometry& geometry, const std::vector<Ray>& rays, RayPacket& packet) {
    bool any = false;
    for (std::size_t i = 0; i < packet.count; ++i) {
        any |= hit_alone(geometry, rays[packet.numbers[i]]).primitive == 0;
    }
    REQUIRE(offer_to_packet(geometry, 0, packet) == any);
    for (std::size_t i = 0; i < packet.count; ++i) {
        const Ray& ray = rays[packet.numbers[i]];
        if (same_bits(packet.hit(i), hit_alone(geometry, ray))) continue;
        CAPTURE(i, packet.count, ray.origin, ray.direction, ray.tmin, ray.tmax);
        CHECK(packet.hit(i).t == hit_alone(geometry, ray).t);
        FAIL("other bits than alone");
    }
    packet.count = 0;
}

/// Offers the geometry's only primitive to rays, in packets of 1, 2, 3... rays of each dominant
/// axis.
void require_same(const Geometry& geometry, const std::vector<Ray>& rays) {
    std::array<RayPacket, 3> packets;
    std::array<std::size_t, 3> sizes{1, 1, 1};
    for (int axis = 0; axis < 3; ++axis) packets[axis].dominant = axis;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RayQuery query(rays[i]);
        RayPacket& packet = packets[query.kz];
        packet.add(i, rays[i], query.ray.direction);
        if (packet.count < sizes[query.kz]) continue;
        sizes[query.kz] = sizes[query.kz] % RayPacket::most + 1;
        require_same(geometry, rays, packet);
    }
}

void check_shapes(int rays_each) {
    for_each_target([&] {
        for (const ShapeCase& shape : shape_cases()) {
            CAPTURE(shape.name);
            Random random(11);
            std::vector<Ray> rays;
            int hits = 0;
            for (int i = 0; i < rays_each; ++i) {
                Ray ray = aimed_ray(shape, i, random).ray;
                const Hit hit = hit_alone(shape.scene.geometry, ray);
                limit(ray, hit, i);
                if (is_valid(ray)) rays.push_back(ray);
                hits += hit.primitive == 0;
            }
            CHECK(10 * hits > rays_each);
            require_same(shape.scene.geometry, rays);
        }
    });
}

}  // namespace

TEST_CASE("Kernels: a ray of a packet has the hit that it has alone, to the bit") {
    check_shapes(4000);
}

TEST_CASE("Kernels: many rays of packets have the hits that they have alone, to the bit",
          "[long]") {
    check_shapes(300'000);
}

TEST_CASE("Kernels: a packet hits degenerate shapes as little as a ray does") {
    for_each_target([&] {
        for (const DegenerateCase& shape : degenerate_cases()) {
            CAPTURE(shape.name);
            Random random(12);
            std::vector<Ray> rays;
            for (int i = 0; i < 500; ++i) {
                const Vec3 direction = random.direction();
                rays.push_back({random.in_cube() - random.uniform(0, 10) * direction, direction});
            }
            require_same(shape.scene.geometry, rays);
        }
    });
}

TEST_CASE("Kernels: of two primitives at the same distance a packet keeps the lower number") {
    Geometry geometry;
    geometry.add(Sphere{Vec3(0), 1}, 0);
    geometry.add(Sphere{Vec3(0), 1}, 0);
    const Ray ray{Vec3(0, 0, 5), Vec3(0, 0, -1)};
    for (const auto& [first, second] : {std::pair(0U, 1U), std::pair(1U, 0U)}) {
        RayPacket packet;
        packet.dominant = 2;
        packet.add(0, ray, RayQuery(ray).ray.direction);
        offer_to_packet(geometry, first, packet);
        offer_to_packet(geometry, second, packet);
        CHECK(packet.hit(0).primitive == 0);
        CHECK(packet.hit(0).t == 4);
    }
}
