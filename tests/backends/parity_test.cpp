// Given the same ray, every exact backend finds the same primitive at the same t, to the last bit,
// and reports occlusion exactly if there is a hit.
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon;
using namespace etalon::test;

namespace {

bool can_hit(const Ray& ray) {
    return is_finite(ray.origin) && is_finite(ray.direction) && max_abs(ray.direction) > 0 &&
           ray.tmin < ray.tmax;
}

std::optional<Hit> expected_hit(const Scene& scene, const Ray& ray) {
    return can_hit(ray) ? brute_force(scene, ray) : std::nullopt;
}

/// The rays, and those around every fourth ray's hit, with their expected hits.
struct Question {
    Ray ray;
    std::optional<Hit> expected;
};

std::vector<Question> questions_for(const Scene& scene, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Question> questions;
    for (const Ray& ray : make_rays(scene, count, random)) {
        const std::optional<Hit> hit = expected_hit(scene, ray);
        questions.push_back({ray, hit});
        if (!hit || !random.one_in(4)) continue;
        for (const Ray& r : around_hit(ray, hit->t))
            questions.push_back({r, expected_hit(scene, r)});
    }
    return questions;
}

/// Counts the rays for which a backend that traces them in one batch finds another hit.
std::size_t count_wrong_in_batch(const Intersector& intersector,
                                 const std::vector<Question>& questions) {
    std::vector<Ray> rays;
    for (const Question& q : questions) rays.push_back(q.ray);
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    intersector.closest(rays, hits);
    intersector.occluded(rays, blocked);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::optional<Hit>& expected = questions[i].expected;
        const bool hit_is_right =
            expected ? hits[i].t == expected->t && hits[i].primitive == expected->primitive
                     : hits[i].primitive == no_index;
        if (!hit_is_right || (blocked[i] != 0) != expected.has_value()) ++wrong;
    }
    return wrong;
}

void require_parity(const Scene& scene, const std::vector<Question>& questions) {
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(scene.geometry);
        std::size_t different = 0;
        std::string first;
        for (const Question& q : questions) {
            const std::string text = difference(*intersector, q.ray, q.expected);
            if (text.empty()) continue;
            if (different++ == 0) first = text;
        }
        INFO(first);
        CHECK(different == 0);
        CHECK(count_wrong_in_batch(*intersector, questions) == 0);
    }
}

void require_parity(const SceneFamily& family, std::size_t primitives, std::size_t rays) {
    INFO("scene " << family.name << " of " << primitives);
    const Scene scene = family.make(primitives);
    require_parity(scene, questions_for(scene, rays, primitives));
}

}  // namespace

TEST_CASE("Given any scene, exact backends agree to the last bit",
          "[backends]" ETALON_LONG_IF_SANITIZED) {
    for (const SceneFamily& family : scene_families()) require_parity(family, 300, 1500);
}

TEST_CASE("Given a handful of primitives, exact backends agree to the last bit", "[backends]") {
    for (const std::size_t count : {1, 2, 3, 9}) {
        for (const SceneFamily& family : scene_families()) require_parity(family, count, 300);
    }
}

TEST_CASE("Given large scenes, exact backends agree to the last bit", "[backends][long]") {
    for (const SceneFamily& family : scene_families()) require_parity(family, 4000, 6000);
}

TEST_CASE("Given many rays, exact backends agree to the last bit", "[backends][long]") {
    for (const SceneFamily& family : scene_families()) require_parity(family, 100, 100000);
}

TEST_CASE("Given no primitives, nothing is hit", "[backends]") {
    const Scene scene;
    require_parity(scene, questions_for(scene, 100, 1));
}

TEST_CASE("Given only degenerate primitives, nothing is hit", "[backends]") {
    Scene scene;
    scene.geometry.vertices.assign(3, Vec3(1));
    scene.geometry.vertices.emplace_back(nan_value, 0, 0);
    scene.geometry.vertices.emplace_back(infinity, 0, 0);
    scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    scene.geometry.add(Triangle{{0, 1, 3}}, 0);
    scene.geometry.add(Triangle{{0, 1, 4}}, 0);
    scene.geometry.add(Polygon{scene.geometry.vertices}, 0);
    scene.geometry.add(Sphere{Vec3(0), 0}, 0);
    scene.geometry.add(Sphere{Vec3(0), nan_value}, 0);
    scene.geometry.add(Box{Vec3(1), Vec3(-1)}, 0);
    scene.geometry.add(Plane{Vec3(0), Vec3(0)}, 0);
    scene.geometry.add(Cone{Vec3(1), Vec3(1), 1, 1}, 0);
    Random random(2);
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(scene.geometry);
        for (const Ray& ray : make_rays(scene, 200, random)) {
            REQUIRE(difference(*intersector, ray, std::nullopt) == "");
        }
    }
}

TEST_CASE("Given rays that are none, nothing is hit", "[backends]") {
    const Scene scene = make_scene("mix", 50);
    const double bad[] = {nan_value, infinity, -infinity};
    std::vector<Ray> rays = {
        {Vec3(0), Vec3(0)}, {Vec3(0), Vec3(1), 2, 1}, {Vec3(0), Vec3(1), 1, 1}};
    for (const double x : bad) {
        rays.push_back({Vec3(0, x, 0), Vec3(1)});
        rays.push_back({Vec3(0), Vec3(1, 1, x)});
    }
    rays.push_back({Vec3(0), Vec3(1), nan_value, 1});
    rays.push_back({Vec3(0), Vec3(1), 0, nan_value});
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(scene.geometry);
        for (const Ray& ray : rays) CHECK(difference(*intersector, ray, std::nullopt) == "");
    }
}

TEST_CASE("Given 1e5 equal primitives, the first is hit and building ends", "[backends]") {
    Scene scene;
    scene.geometry.vertices = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
    for (int i = 0; i < 50000; ++i) {
        scene.geometry.add(Triangle{{0, 1, 2}}, 0);
        scene.geometry.add(Sphere{Vec3(0), 0.5}, 0);
    }
    const Ray at_sphere{Vec3(0, 0, 3), Vec3(0, 0, -1)},
        at_triangle{Vec3(0.5, -0.875, 3), Vec3(0, 0, -1)};
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(scene.geometry);
        CHECK(difference(*intersector, at_sphere, Hit{2.5, 1}) == "");
        CHECK(difference(*intersector, at_triangle, Hit{3, 0}) == "");
    }
}
