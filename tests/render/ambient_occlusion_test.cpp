// Compares ambient occlusion with closed forms. Cosine-weighted directions are uniform points of
// the unit disk below them, so visibility is an area of the disk divided by pi.
#include <cmath>
#include <numbers>

#include "tests/catch.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// An empty scene with one pixel so narrow that all its rays hit the point `at`.
TestScene looking_at(const Vec3& eye, const Vec3& at) {
    TestScene scene = empty_scene(1, 1);
    scene.camera.eye = eye;
    scene.camera.at = at;
    scene.camera.fov_degrees = 1e-6;
    scene.whitted().materials = {matte(Color(0.5F))};
    scene.settings.integrator = "ao";
    scene.settings.samples_per_pixel = 1 << 14;
    return scene;
}

/// The floor y = 0, seen at the point (`distance`, 0, 0) from above.
TestScene floor_at(double distance) {
    TestScene scene = looking_at(Vec3(distance + 1, 2, 0.5), Vec3(distance, 0, 0));
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 1, 0)}, 0);
    return scene;
}

float visible(const TestScene& scene) {
    const Color c = image(scene)[0];
    CHECK(c.x == c.y);
    CHECK(c.y == c.z);
    return c.x;
}

/// A wall at x = 0 that faces the point on the floor and is nearly infinite along z.
Box wall(double height) {
    return {Vec3(-1, -1, -1e5), Vec3(0, height, 1e5)};
}

}  // namespace

TEST_CASE("An open plane is white, from either side, and a miss is black", "[ao]") {
    TestScene scene = floor_at(0);
    CHECK(visible(scene) == 1);
    scene.camera.eye.y = -2;
    CHECK(visible(scene) == 1);
    scene.camera.at = 2.0 * scene.camera.eye;  // away from the plane
    CHECK(visible(scene) == 0);
}

TEST_CASE("The inside of a sphere is black, to the last pixel", "[ao]") {
    TestScene scene = empty_scene(64, 48);
    scene.whitted().materials = {matte(Color(0.5F))};
    scene.camera.fov_degrees = 120;
    scene.geometry.add(Sphere{Vec3(1, 2, 3), 20}, 0);
    scene.settings.integrator = "ao";
    scene.settings.samples_per_pixel = GENERATE(0, 16);
    for (const Color& c : image(scene)) REQUIRE(c == Color(0.0F));
    scene.settings.max_distance = 1e-3;  // such a short chord is nearly in the surface
    const std::vector<Color> near = image(scene);
    CHECK(std::ranges::all_of(near, [](const Color& c) { return c.x > 0.9F; }));
}

TEST_CASE("An endless wall hides half of the floor's sky, wherever", "[ao]") {
    TestScene scene = floor_at(GENERATE(0.01, 1.0, 50.0));
    scene.geometry.add(Plane{Vec3(0), Vec3(1, 0, 0)}, 0);
    CHECK(visible(scene) == Approx(0.5).margin(1e-3));
}

// At an infinite edge, the directions up to the angle a from the normal are (1 + sin a) / 2 of the
// disk.
TEST_CASE("A wall of height h hides (1 - x / sqrt(x^2 + h^2)) / 2 of the sky at x", "[ao]") {
    const double x = GENERATE(0.25, 1.0, 3.0), h = GENERATE(0.5, 2.0);
    TestScene scene = floor_at(x);
    scene.geometry.add(wall(h), 0);
    CHECK(visible(scene) == Approx((1 + x / std::hypot(x, h)) / 2).margin(1e-3));
}

// Within the distance D, a wall at x hides the directions whose component towards it is at least
// x / D: a segment of the disk.
TEST_CASE("Within a distance, an endless wall hides a segment of the disk", "[ao]") {
    const double x = 0.75;
    TestScene scene = floor_at(x);
    scene.geometry.add(Plane{Vec3(0), Vec3(1, 0, 0)}, 0);
    for (const double distance : {0.8, 1.0, 2.0, 30.0}) {
        scene.settings.max_distance = distance;
        const double c = x / distance;
        const double hidden = (std::acos(c) - c * std::sqrt(1 - c * c)) / std::numbers::pi;
        CAPTURE(distance);
        CHECK(visible(scene) == Approx(1 - hidden).margin(1e-3));
    }
    scene.settings.max_distance = 0.74;
    CHECK(visible(scene) == 1);
}

TEST_CASE("Every camera hit takes one occlusion ray, and 64 where a pixel has one camera ray",
          "[ao]") {
    TestScene scene = mixed_scene();
    scene.settings.integrator = "ao";
    const RayCounts counts = rendered(scene).counts;
    CHECK(counts.camera == 48 * 36 * 5);
    CHECK(counts.camera_hits > 1000);
    CHECK(counts.shadow == counts.camera_hits);
    CHECK(counts.shadow_blocked > 100);
    CHECK(counts.shadow_blocked < counts.shadow);
    CHECK(counts.total() == counts.camera + counts.shadow);
    scene.settings.samples_per_pixel = 0;
    const RayCounts without = rendered(scene).counts;
    CHECK(without.camera == 48 * 36);
    CHECK(without.shadow == 64 * without.camera_hits);
}

TEST_CASE("Lights and materials change no ambient occlusion", "[ao]") {
    TestScene scene = mixed_scene();
    scene.settings.integrator = "ao";
    const std::vector<Color> before = image(scene);
    scene.whitted().lights.clear();
    for (Material& m : scene.whitted().materials) m = matte(Color(0.0F));
    CHECK(image(scene) == before);
}
