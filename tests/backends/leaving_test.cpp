// Rays that exclude the primitive that they left.
#include "core/intersect/kernels.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

Ray without_hint(Ray ray) {
    ray.exclude = no_index;
    return ray;
}

/// Returns rays from the hits of others, to both sides.
std::vector<Ray> leaving_rays(const Scene& scene, std::size_t count) {
    Random random(count);
    std::vector<Ray> rays;
    for (const Ray& ray : make_rays(scene, count, random)) {
        const auto hit = brute_force(scene, ray);
        if (!hit) continue;
        const SurfacePoint p = surface_at(scene.geometry, ray, *hit);
        rays.push_back(spawn_ray(p, random.direction()));
        rays.push_back(spawn_ray_to(p, p.position + random.direction()));
    }
    return rays;
}

}  // namespace

TEST_CASE("Given a ray that says what it left, it hits what one that does not say so hits",
          "[leaving]") {
    for (const SceneFamily& family : scene_families()) {
        const Scene scene = transformed(family.make(200), 3, Vec3(70, -30, 0.1));
        const std::vector<Ray> rays = leaving_rays(scene, 400);
        for (const Backend& backend : exact_backends()) {
            INFO(backend.name << " on " << family.name);
            const auto intersector = backend.build(scene.geometry);
            for (const Ray& ray : rays) {
                const std::string found =
                    difference(*intersector, ray, brute_force(scene, without_hint(ray)));
                REQUIRE(found == "");
            }
        }
    }
}

TEST_CASE(
    "Given a flat primitive, or a convex one that is left outward, a ray says that it left it",
    "[leaving]") {
    SurfacePoint p{Vec3(0), Vec3(1e-15), Vec3(0, 0, 1), Vec3(0, 0, 1), 7, 0, Convexity::any};
    const Vec3 outward(1, 0, 1), inward(1, 0, -1);
    p.convexity = Convexity::flat;
    CHECK(spawn_ray(p, outward).exclude == 7);
    CHECK(spawn_ray(p, inward).exclude == 7);
    p.convexity = Convexity::convex;
    CHECK(spawn_ray(p, outward).exclude == 7);
    CHECK(spawn_ray(p, inward).exclude == no_index);
    p.convexity = Convexity::any;
    CHECK(spawn_ray(p, outward).exclude == no_index);
    p.convexity = Convexity::flat;
    p.instance = 3;
    CHECK(spawn_ray(p, outward).exclude == key_of(7, 3));
    CHECK(spawn_ray(p, outward).excluded(3) == 7);
    CHECK(spawn_ray(p, outward).excluded(4) == no_index);
    CHECK(spawn_ray(p, outward).excluded() == no_index);
    p.instance = 1 << 21;
    CHECK(spawn_ray(p, outward).exclude == no_index);
}
