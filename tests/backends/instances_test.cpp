// Instances: every exact backend finds the hits that the kernels find for rays transformed to
// object space.
#include "bench/hard_cases/hard_case.h"
#include "core/intersect/kernels.h"
#include "core/scene/transformed.h"
#include "tests/backends/instance_checks.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

std::vector<Ray> rays_of(const hard::CaseSetup& setup, std::uint64_t count) {
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < count; ++i) {
        Random random(9, i);
        rays.push_back(setup.ray(random));
    }
    return rays;
}

template <class Visit>
void for_each_case(const Visit& visit) {
    for (const hard::HardCase& c : hard::hard_cases()) {
        if (!c.id.starts_with("INST") || c.criterion == hard::Criterion::enclosed) continue;
        INFO(c.id << ", " << c.variant);
        visit(c.make());
    }
}

}  // namespace

TEST_CASE("Given instances, exact backends find what the kernels find", "[instances]") {
    for_each_case([](const hard::CaseSetup& setup) {
        const Geometry& geometry = setup.scene.geometry;
        const std::vector<Ray> rays = rays_of(setup, 400);
        std::vector<Hit> expected;
        for (const Ray& ray : rays) expected.push_back(all_tested(geometry, ray));
        for (const Backend& backend : exact_backends()) {
            INFO("backend " << backend.name);
            CHECK(count_wrong(backend, geometry, rays, expected) == 0);
        }
    });
}

TEST_CASE("Given rays that say what they left of an instance, they hit what others hit",
          "[instances]") {
    std::size_t excluding = 0;
    for_each_case([&](const hard::CaseSetup& setup) {
        const Geometry& geometry = setup.scene.geometry;
        Random random(10);
        std::vector<Ray> rays;
        std::vector<Hit> expected;
        for (const Ray& ray : rays_of(setup, 400)) {
            const Hit hit = all_tested(geometry, ray);
            if (hit.primitive == no_index) continue;
            Ray leaving = spawn_ray(surface_at(geometry, ray, hit), random.direction());
            rays.push_back(leaving);
            excluding += leaving.exclude != no_index;
            leaving.exclude = no_index;
            expected.push_back(all_tested(geometry, leaving));
        }
        for (const Backend& backend : exact_backends()) {
            INFO("backend " << backend.name);
            CHECK(count_wrong(backend, geometry, rays, expected) == 0);
        }
    });
    CHECK(excluding > 1000);
}

TEST_CASE("Given a ray that excludes a primitive of an instance, it hits that of the next",
          "[instances]") {
    Geometry geometry;
    for (const double size : {1.0, 2.0}) {
        Geometry& object = geometry.objects.emplace_back();
        object.vertices = {{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
        object.add(Triangle{{0, 1, 2}}, 0);
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        geometry.instances.emplace_back(Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, double(i)}},
                                        i % 2);
    }
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(geometry);
        for (std::uint32_t i = 0; i < 6; ++i) {
            Ray ray{{0, 0, i - 0.5}, {0, 0, 1}};
            CHECK(intersector->closest(ray)->instance == i);
            ray.exclude = key_of(0, i);
            const auto hit = intersector->closest(ray);
            CHECK(hit.has_value() == (i < 5));
            if (hit) CHECK(hit->instance == i + 1);
            CHECK(intersector->occluded(ray) == (i < 5));
        }
    }
}

TEST_CASE("Given instances in a scene scaled by a power of two, hits are the same", "[instances]") {
    for_each_case([](const hard::CaseSetup& setup) {
        const double k = 0x1p-9;
        const Scene small = transformed(setup.scene, k);
        for (const Backend& backend : exact_backends()) {
            if (backend.name == "none") continue;
            const auto large = backend.build(setup.scene.geometry);
            const auto scaled = backend.build(small.geometry);
            for (Ray ray : rays_of(setup, 200)) {
                const Hit a = large->closest(ray).value_or(Hit{0, no_index});
                ray.origin *= k, ray.direction *= k;
                CHECK(same(scaled->closest(ray).value_or(Hit{0, no_index}), a));
            }
        }
    });
}

TEST_CASE("Given a primitive and instances at the same distance, the primitive wins",
          "[instances]") {
    Geometry geometry;
    geometry.objects.resize(2);
    for (Geometry& object : geometry.objects) {
        object.add(Sphere{{0, 0, 5}, 1}, 0);
        object.add(Sphere{{0, 0, 0}, 1}, 0);
        object.add(Sphere{{0, 0, 0}, 1}, 0);
    }
    for (const std::uint32_t object : {1, 0, 1}) geometry.instances.emplace_back(Affine{}, object);
    const Ray ray{{0, 0, -3}, {0, 0, 1}};
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto only_instances = backend.build(geometry);
        CHECK(same(only_instances->closest(ray).value(), {2, 1, 0}));
        Geometry with_primitive = geometry;
        with_primitive.add(Sphere{{0, 0, 0}, 1}, 0);
        CHECK(same(backend.build(with_primitive)->closest(ray).value(), {2, 0}));
    }
}

TEST_CASE("Given an instance just before a primitive, it is found after that", "[instances]") {
    Geometry geometry;
    geometry.add(Box{{-1, -1, 0}, {1, 1, 1}}, 0);
    geometry.objects.resize(1);
    geometry.objects[0].add(Box{{-1, -1, 0}, {1, 1, 0}}, 0);
    geometry.instances.emplace_back(Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -0x1p-32}}, 0);
    Random random(32);
    std::vector<Ray> rays;
    std::vector<Hit> expected;
    for (int i = 0; i < 500; ++i) {
        const Vec3 origin = Vec3(0, 0, -3) + random.in_cube();
        rays.push_back({origin, 0.5 * random.in_cube() - origin});
        expected.push_back(all_tested(geometry, rays.back()));
        REQUIRE(expected.back().instance == 0);
    }
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        CHECK(count_wrong(backend, geometry, rays, expected) == 0);
    }
}

TEST_CASE("Given instances of empty objects, nothing is hit", "[instances]") {
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.instances.assign(3, Instance(Affine{}, 0));
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        CHECK_FALSE(backend.build(geometry)->closest(Ray{{0, 0, -3}, {0, 0, 1}}));
    }
}

TEST_CASE("Given thousands of objects, every backend builds them and finds each", "[instances]") {
    constexpr std::uint32_t count = 2000;
    Geometry geometry;
    geometry.objects.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        geometry.objects[i].add(Sphere{Vec3(0), 0.25}, 0);
        geometry.instances.emplace_back(Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {double(i), 0, 0}},
                                        i);
    }
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(geometry);
        for (std::uint32_t i = 0; i < count; i += 97) {
            const auto hit = intersector->closest(Ray{{double(i), 0, -3}, {0, 0, 1}});
            REQUIRE(hit);
            CHECK(hit->instance == i);
            CHECK(hit->t == 2.75);
        }
    }
}
