// Packets find the same hits as single rays, and are really used.
#include <atomic>

#include "core/intersect/packet_intersector.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Counts the rays that are passed to a backend.
class CountingBackend : public BatchIntersector {
  public:
    explicit CountingBackend(const BatchIntersector& backend) : backend_(backend) {}

    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override {
        count += rays.size();
        backend_.closest(rays, hits);
    }
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        count += rays.size();
        backend_.occluded(rays, blocked);
    }
    using BatchIntersector::closest, BatchIntersector::occluded;

    mutable std::size_t count = 0;

  private:
    const BatchIntersector& backend_;
};

/// Returns coherent rays in groups of 1 to 64, around rays at corners, at edges and anywhere. Some
/// have a tmin or tmax at their hit.
std::vector<Ray> bundles(const Scene& scene, std::size_t number, Random& random) {
    std::vector<Ray> rays;
    for (const Ray& ray : make_rays(scene, number, random)) {
        const double step = random.magnitude(-9, -2);
        const std::size_t count = 1 + random.index(64);
        const bool starts_apart = random.one_in(2);
        for (std::size_t i = 0; i < count; ++i) {
            Ray next = ray;
            next.direction += step * max_abs(ray.direction) * random.in_cube();
            if (starts_apart) next.origin += step * random.in_cube();
            rays.push_back(next);
        }
        if (const auto hit = brute_force(scene, ray); hit && random.one_in(4)) {
            for (const Ray& r : around_hit(ray, hit->t)) rays.push_back(r);
        }
    }
    rays[rays.size() / 2].direction *= 0x1p-200;
    rays[rays.size() / 3].direction *= 0x1p200;
    for (Ray& ray : rays) ray.set_coherent();
    return rays;
}

/// Traces the rays of a span or a stream. Returns the number of results that differ from those of
/// single rays.
template <class Rays>
std::size_t count_wrong(const Scene& scene, const BatchIntersector& intersector, const Rays& rays) {
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    intersector.closest(rays, hits);
    intersector.occluded(rays, blocked);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::optional<Hit> expected =
            is_valid(rays[i]) ? brute_force(scene, rays[i]) : std::nullopt;
        const bool is_right =
            expected ? same_bits(hits[i], expected) : hits[i].primitive == no_index;
        wrong += !is_right || (blocked[i] != 0) != expected.has_value();
    }
    return wrong;
}

/// Returns a hundred spheres side by side.
Geometry wall_of_spheres() {
    Geometry geometry;
    for (int i = 0; i < 100; ++i) geometry.add(Sphere{Vec3(i % 10, i / 10, 0), 0.3}, 0);
    return geometry;
}

/// Returns coherent rays of one origin to all parts of the wall and beyond it.
std::vector<Ray> rays_at_wall() {
    std::vector<Ray> rays;
    for (int i = 0; i < 64 * 64; ++i) {
        Ray& ray = rays.emplace_back();
        ray.origin = Vec3(4.5, 4.5, 20);
        ray.direction = Vec3(i % 64 / 64.0 - 0.5, i / 64 / 64.0 - 0.5, -2);
        ray.set_coherent();
    }
    return rays;
}

}  // namespace

TEST_CASE("Packets: rays in bundles find what each of them finds alone, to the bit", "[backends]") {
    for_each_target([] {
        for (const SceneFamily& family : scene_families()) {
            const Scene scene = family.make(100);
            INFO(family.name);
            Random random(17);
            const auto backend = backend_named("bvh").build(scene.geometry);
            const PacketIntersector packets(scene.geometry, *backend, true);
            REQUIRE(packets.has_packets());
            CHECK(count_wrong(scene, packets, bundles(scene, 60, random)) == 0);
        }
    });
}

TEST_CASE("Packets: rays of a stream find what each of them finds alone, to the bit",
          "[backends]") {
    for_each_target([] {
        for (const SceneFamily& family : scene_families()) {
            const Scene scene = family.make(100);
            INFO(family.name);
            Random random(18);
            const auto backend = backend_named("bvh").build(scene.geometry);
            const PacketIntersector packets(scene.geometry, *backend, true);
            const std::vector<Ray> rays = bundles(scene, 30, random);
            RayBuffer buffer;
            buffer.make_room(rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) buffer.set(i, rays[i]);
            RayStream stream = buffer.view(rays.size());
            stream.traits = Ray::coherent_trait;
            CHECK(count_wrong(scene, packets, stream) == 0);
            stream.tmax = 0.8;
            CHECK(count_wrong(scene, packets, stream.subspan(7)) == 0);
            CHECK(count_wrong(scene, *backend, stream.first(100)) == 0);
        }
    });
}

TEST_CASE("Packets: of camera rays past some spheres few are left to the backend", "[backends]") {
    const Geometry geometry = wall_of_spheres();
    const auto backend = backend_named("bvh").build(geometry);
    const CountingBackend counting(*backend);
    const PacketIntersector packets(geometry, counting, true);
    std::vector<Ray> rays = rays_at_wall();
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    packets.closest(rays, hits);
    packets.occluded(rays, blocked);
    CHECK(counting.count == 0);
    CHECK(std::ranges::count(blocked, 1) > 200);

    rays[0].traits_and_time = 0;
    packets.closest(rays, hits);
    CHECK(counting.count == rays.size());
}

TEST_CASE("Packets: what occludes most rays is found once, however much else there is",
          "[backends]") {
    Geometry geometry = wall_of_spheres();
    geometry.add(Box{Vec3(-20, 4.6, 1), Vec3(20, 20, 2)}, 0);
    const auto backend = backend_named("bvh").build(geometry);
    const CountingBackend counting(*backend);
    const PacketIntersector packets(geometry, counting, true);
    const std::vector<Ray> in_order = rays_at_wall();
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < in_order.size(); ++i) {
        rays.push_back(in_order[i * 1021 % in_order.size()]);  // so that packets are wide
    }
    std::vector<std::uint8_t> blocked(rays.size()), expected(rays.size());
    packets.occluded(rays, blocked);
    backend->occluded(rays, expected);
    CHECK(blocked == expected);
    CHECK(counting.count < rays.size() * 5 / 8);
}

TEST_CASE("Packets: scenes of many primitives, and other backends, are left alone", "[backends]") {
    const auto has_packets = [](std::size_t spheres, bool is_exact) {
        const Scene scene = make_scene("spheres", spheres);
        const auto backend = backend_named("bvh").build(scene.geometry);
        return PacketIntersector(scene.geometry, *backend, is_exact).has_packets();
    };
    CHECK(has_packets(100, true));
    CHECK_FALSE(has_packets(100, false));
    CHECK_FALSE(has_packets(1000, true));
}
