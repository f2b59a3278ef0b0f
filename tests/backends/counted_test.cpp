// Counted nearest-hit queries: they find the same hits, and the counts are plausible.
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

TraversalCost cost_of(const Intersector& intersector, const std::vector<Ray>& rays) {
    TraversalCost cost;
    for (const Ray& ray : rays) intersector.closest(ray, cost);
    return cost;
}

/// Eight small spheres around one point, and eight around another.
Scene two_heaps() {
    Scene scene;
    for (int i = 0; i < 16; ++i) {
        const Vec3 heap(i < 8 ? -100 : 100, 0, 0);
        scene.geometry.add(Sphere{heap + Vec3(i & 1, i >> 1 & 1, i >> 2 & 1), 0.1}, 0);
    }
    return scene;
}

/// A thousand spheres as small as a pebble in a unit ball, around `place`.
Scene pebbles(const Vec3& place) {
    Scene scene;
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        scene.geometry.add(Sphere{place + random.in_cube(), 0.004}, 0);
    }
    return scene;
}

/// Spheres from 2^-26 to 1 large, as instances, each up to eight times as far from the origin as it
/// is large.
Scene nested_spheres(int count) {
    Scene scene;
    scene.geometry.objects.emplace_back().add(Sphere{Vec3(0), 0.5}, 0);
    Random random(4);
    for (int i = 0; i < count; ++i) {
        const double size = random.magnitude(-8, 0);
        const Vec3 place = 8 * size * random.in_cube();
        const Affine map{{size, 0, 0}, {0, size, 0}, {0, 0, size}, place};
        scene.geometry.instances.emplace_back(map, 0);
    }
    return scene;
}

}  // namespace

TEST_CASE("Given a ray, a query that counts finds the same hit to the last bit", "[backends]") {
    for (const SceneFamily& family : scene_families()) {
        const Scene scene = family.make(300);
        Random random(7);
        const std::vector<Ray> rays = make_rays(scene, 500, random);
        for (const Backend& backend : exact_backends()) {
            INFO(family.name << ", backend " << backend.name);
            const auto intersector = backend.build(scene.geometry);
            TraversalCost cost;
            std::size_t different = 0;
            for (const Ray& ray : rays) {
                different += !same_bits(intersector->closest(ray, cost), intersector->closest(ray));
            }
            CHECK(different == 0);
        }
    }
}

TEST_CASE("Given many primitives, an accelerator tests far fewer of them", "[backends]") {
    const Scene scene = make_scene("mix", 4000);
    Random random(8);
    std::vector<Ray> rays = make_rays(scene, 500, random);
    // Rays from too far away are tested against all primitives by every backend.
    const NormalizedSpace space = SceneBounds::of(scene.geometry).space;
    std::erase_if(rays, [&](const Ray& ray) { return !space.resolves(ray); });
    REQUIRE(rays.size() > 400);
    const auto none = backend_named("none").build(scene.geometry);
    const auto all_tests = cost_of(*none, rays).primitive_tests;
    for (const Backend& backend : exact_backends()) {
        if (!backend.counts_box_tests) continue;
        INFO("backend " << backend.name);
        const TraversalCost cost = cost_of(*backend.build(scene.geometry), rays);
        if (backend.name == "none") {
            CHECK(cost.box_tests == 0);
            continue;
        }
        CHECK(cost.primitive_tests > 0);
        CHECK(cost.primitive_tests < all_tests / 40);
        CHECK(cost.box_tests > 0);
    }
}

TEST_CASE("Given two heaps, a ray at one costs two boxes and the heap", "[backends]") {
    const Scene scene = two_heaps();
    const auto bvh = backend_named("bvh").build(scene.geometry);
    TraversalCost cost;
    REQUIRE(bvh->closest({Vec3(-100, 0, 9), Vec3(0, 0, -1)}, cost));
    CHECK(cost.box_tests == 2);
    CHECK(cost.primitive_tests == 8);
    CHECK_FALSE(bvh->closest({Vec3(0, 0, 9), Vec3(0, 0, -1)}, cost));
    CHECK(cost.box_tests == 4);
    CHECK(cost.primitive_tests == 8);
}

TEST_CASE("Given a plane, it is tested once more for every ray", "[backends]") {
    Scene scene = two_heaps();
    scene.geometry.add(Plane{Vec3(0, 0, -9), Vec3(0, 0, 1)}, 0);
    const auto bvh = backend_named("bvh").build(scene.geometry);
    TraversalCost cost;
    REQUIRE(bvh->closest({Vec3(-100, 0, 9), Vec3(0, 0, -1)}, cost)->primitive == 4);
    CHECK(cost.primitive_tests == 9);
    CHECK_FALSE(bvh->closest({Vec3(0), Vec3(0)}, cost));  // no ray: nothing is tested
    CHECK(cost.primitive_tests == 9);
}

TEST_CASE("A large ground, near the world's origin or far from it, does not blur small primitives",
          "[backends]") {
    for (const double size : {1e3, 1e4, 1e5}) {
        for (const Vec3& place : {Vec3(0), Vec3(5e5, 4e6, 0)}) {
            Scene scene = pebbles(place);
            Random random(4);
            std::vector<Ray> rays;
            for (int i = 0; i < 500; ++i) {
                rays.push_back({place + 3.0 * random.direction(), random.direction()});
            }
            const auto exact = exact_backends();
            std::vector<std::uint64_t> tests;
            for (const Backend& backend : exact) {
                tests.push_back(cost_of(*backend.build(scene.geometry), rays).primitive_tests);
            }
            scene.geometry.add(Sphere{place - Vec3(0, 0, size + 2), size}, 0);
            for (std::size_t i = 0; i < exact.size(); ++i) {
                INFO(exact[i].name << ", a ground of " << size << " at " << place.x);
                const auto found = cost_of(*exact[i].build(scene.geometry), rays).primitive_tests;
                CHECK(found <= 2 * tests[i] + rays.size());
            }
        }
    }
}

TEST_CASE("Given instances of nested sizes, a ray among them is taken to few", "[backends]") {
    const Scene scene = nested_spheres(5000);
    const auto bvh = backend_named("bvh").build(scene.geometry);
    Random random(5);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) rays.push_back({0.01 * random.in_cube(), random.in_cube()});
    const TraversalCost cost = cost_of(*bvh, rays);
    CHECK(cost.primitive_tests < 5 * rays.size());
}
