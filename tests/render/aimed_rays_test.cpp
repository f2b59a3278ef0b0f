#include "core/test_rays/aimed_rays.h"

#include <algorithm>
#include <set>

#include "app/common/backends.h"
#include "core/intersect/kernels.h"
#include "core/test_rays/ray_sets.h"
#include "tests/catch.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const Box3 cube(Vec3(-1), Vec3(1));

/// Distance from the sphere's centre at which the ray passes, in radii.
double passage(const Ray& ray, const Sphere& s) {
    const Vec3 f = s.centre - ray.origin;
    return f.cross(ray.direction).length() / ray.direction.length() / s.radius;
}

bool same(const Ray& a, const Ray& b) {
    return a.origin == b.origin && a.direction == b.direction;
}

}  // namespace

TEST_CASE("Rays at a sphere pass within 2^-20 of tangent on either side", "[render]") {
    Scene scene = empty_scene();
    const Sphere sphere{Vec3(0.3, 0.1, -7), 0.5};
    scene.geometry.add(sphere, 0);
    int inside = 0, outside = 0, from_eye = 0;
    for (const Ray& ray : rays_at_features(scene, cube, 600)) {
        const double off = passage(ray, sphere) - 1;
        if (std::abs(off) < 0x1p-20) ++(off < 0 ? inside : outside);
        if (ray.origin == scene.camera.eye) ++from_eye;
        CHECK(std::abs(off) <= 1.1);
    }
    CHECK(inside > 40);
    CHECK(outside > 40);
    CHECK(from_eye == 300);
}

TEST_CASE("Rays at a box go through its corners and edges to the bit", "[render]") {
    Scene scene = empty_scene();
    const Box box{Vec3(-0.25, -1, 0.5), Vec3(0.75, -0.5, 1)};
    scene.geometry.add(box, 0);
    int on_faces[4] = {};
    for (const Ray& ray : rays_at_features(scene, cube, 400)) {
        const Vec3 p = ray.origin + ray.direction;
        int count = 0;
        for (int k = 0; k < 3; ++k) count += p[k] == box.min[k] || p[k] == box.max[k] ? 1 : 0;
        ++on_faces[count];
    }
    CHECK(on_faces[2] > 20);
    CHECK(on_faces[3] > 20);
}

TEST_CASE("Every kind of shape is aimed at alike, however many there are of it", "[render]") {
    Scene scene = empty_scene();
    scene.geometry.add(Sphere{Vec3(0, 0, -9), 0.001}, 0);
    for (int i = 0; i < 1000; ++i)
        scene.geometry.add(Box{Vec3(2 * i, 0, 9), Vec3(2 * i + 1, 1, 10)}, 0);
    int at_sphere = 0;
    std::set<int> boxes;
    for (const Ray& ray : rays_at_features(scene, cube, 400)) {
        const Vec3 target = ray.origin + ray.direction;
        if (target.z < 0) {
            ++at_sphere;
        } else {
            boxes.insert(static_cast<int>(target.x / 2));
        }
    }
    CHECK(boxes.size() > 100);
    CHECK(at_sphere > 150);
    CHECK(at_sphere < 250);
}

TEST_CASE("Rays at borders come in pairs that are next to each other and see different things",
          "[render]") {
    const TestScene scene = mixed_scene();
    const auto exact = find_backend(default_backend)->build(scene.geometry);
    std::vector<Ray> rays;
    std::vector<Vec2> pixels;
    for (int x = 0; x < 48; ++x) pixels.emplace_back(x + 0.5, 18.5);
    add_rays_at_borders(*exact, CameraRays(scene.camera, scene.settings.resolution), pixels, 100,
                        rays);
    REQUIRE(rays.size() >= 8);
    for (std::size_t i = 0; i < rays.size(); i += 2) {
        const auto a = exact->closest(rays[i]), b = exact->closest(rays[i + 1]);
        CHECK((a ? a->primitive : no_index) != (b ? b->primitive : no_index));
        CHECK(max_abs(rays[i].direction - rays[i + 1].direction) < 0x1p-48);
    }
}

TEST_CASE("The same scene gives the same aimed rays, and one without shapes none", "[render]") {
    const Scene scene = mixed_scene();
    const auto once = rays_at_features(scene, cube, 50), again = rays_at_features(scene, cube, 50);
    CHECK(std::equal(once.begin(), once.end(), again.begin(), again.end(), same));
    CHECK(rays_at_features(empty_scene(), cube, 50).empty());
}
