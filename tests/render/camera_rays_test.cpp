#include "core/render/camera_rays.h"

#include <cmath>

#include "tests/chi_square.h"
#include "tests/render/rays_together.h"

using namespace etalon;
using namespace etalon::test;

namespace {

Camera looking_down_z() {
    return {Vec3(0, 0, 5), Vec3(0), Vec3(0, 1, 0), 90, 0, 1};
}

const Imath::V2i size(200, 100);

}  // namespace

TEST_CASE("The vertical field of view spans the full height of the image", "[render]") {
    const CameraRays camera(looking_down_z(), size);
    const Ray top = camera.ray(Vec2(100, 0), Vec2(0.5));
    CHECK(top.direction.y == Approx(std::sqrt(0.5)));
    CHECK(top.direction.z == Approx(-std::sqrt(0.5)));
    const Ray right = camera.ray(Vec2(200, 50), Vec2(0.5));  // square pixels: twice as wide
    CHECK(right.direction.x / -right.direction.z == Approx(2));
    CHECK(camera.ray(Vec2(100, 50), Vec2(0.5)).direction == Vec3(0, 0, -1));
}

TEST_CASE("A stretched image has its field of view in both directions", "[render]") {
    Camera c = looking_down_z();
    c.stretched = true;
    const CameraRays camera(c, size);
    const Ray corner = camera.ray(Vec2(200, 0), Vec2(0.5));
    CHECK(corner.direction.x / -corner.direction.z == Approx(1));
    CHECK(corner.direction.y / -corner.direction.z == Approx(1));
    Vec3 ndc;
    camera.world_to_ndc()->multVecMatrix(corner.origin + 3.0 * corner.direction, ndc);
    CHECK(ndc.x == Approx(1));
    CHECK(ndc.y == Approx(1));
}

TEST_CASE("A lens moves the origin and keeps the focus plane sharp", "[render]") {
    Camera c = looking_down_z();
    c.aperture = 8;  // pixels; one is 2 * 5 * tan(45 deg) / 100 = 0.1 on the view plane
    c.focal = 2;     // the plane z = 5 - 2 * 5
    const CameraRays camera(c, size);
    const Ray centre = camera.ray(Vec2(30, 70), Vec2(0.5));
    CHECK(centre.origin == c.eye);
    const Vec3 focus = centre.origin + centre.direction * (-10 / centre.direction.z);
    for (const Vec2& lens : {Vec2(0, 0), Vec2(1, 0.3), Vec2(0.5, 1), Vec2(0.9, 0.8)}) {
        const Ray ray = camera.ray(Vec2(30, 70), lens);
        CHECK((ray.origin - c.eye).length() <= 0.4 * (1 + 1e-12));
        const Vec3 there = ray.origin + ray.direction * (-10 / ray.direction.z);
        CHECK((there - focus).length() < 1e-12);
    }
    CHECK((camera.ray(Vec2(30, 70), Vec2(1, 0.5)).origin - c.eye).length() == Approx(0.4));
    c.stretched = true;  // pixels are narrower; the lens is as wide as eight of them are high
    const Ray narrow = CameraRays(c, size).ray(Vec2(30, 70), Vec2(1, 0.5));
    CHECK((narrow.origin - c.eye).length() == Approx(0.4));
}

namespace {

/// Numbers of points in 8 x 16 parts of a disk of radius 1, all of the same area.
std::vector<double> numbers_on_disk(const std::vector<Vec2>& points) {
    std::vector<double> numbers(8 * 16);
    for (const Vec2& p : points) {
        const auto ring = static_cast<int>(8 * std::min(p.length2(), 1 - 1e-9));
        const double turn = (std::atan2(p.y, p.x) + M_PI) / (2 * M_PI);
        ++numbers[ring * 16 + static_cast<int>(16 * std::min(turn, 1 - 1e-9))];
    }
    return numbers;
}

}  // namespace

TEST_CASE("Rays begin anywhere on a lens with the same density", "[render]") {
    Camera c = looking_down_z();
    c.aperture = 8;
    c.focal = 2;
    const CameraRays camera(c, size);
    Random random(3);
    std::vector<Vec2> origins, too_central;
    for (int i = 0; i < 100'000; ++i) {
        const Vec2 lens(random.uniform(), random.uniform());
        const Vec3 from = camera.ray(Vec2(30, 70), lens).origin - c.eye;
        origins.push_back(Vec2(from.x, from.y) / 0.4);
        too_central.push_back(origins.back() * std::pow(origins.back().length(), 0.03));
    }
    const std::vector<double> expected(8 * 16, 100'000.0 / (8 * 16));
    CHECK(chi_square_probability(numbers_on_disk(origins), expected) > 1e-3);
    CHECK(chi_square_probability(numbers_on_disk(too_central), expected) < 1e-3);
}

TEST_CASE("world_to_ndc maps a point seen by a pixel to the pixel's position", "[render]") {
    Camera c{Vec3(3, -2, 5), Vec3(0.5, 1, -1), Vec3(0.2, 1, 0.1), 40, 0, 1};
    const CameraRays camera(c, {320, 200});
    const Ray ray = camera.ray(Vec2(80, 50), Vec2(0.5));
    Vec3 ndc;
    camera.world_to_ndc()->multVecMatrix(ray.origin + 7.0 * ray.direction, ndc);
    CHECK(ndc.x == Approx(-0.5));
    CHECK(ndc.y == Approx(0.5));
    Vec3 in_camera;
    camera.world_to_camera().multVecMatrix(c.at, in_camera);
    CHECK(in_camera.x == Approx(0).margin(1e-12));
    CHECK(in_camera.y == Approx(0).margin(1e-12));
    CHECK(in_camera.z == Approx(-(c.at - c.eye).length()));
}

TEST_CASE("An up vector along the view direction still gives a frame", "[render]") {
    Camera c = looking_down_z();
    c.up = Vec3(0, 0, 1);
    const Ray ray = CameraRays(c, size).ray(Vec2(10, 10), Vec2(0.5));
    CHECK(is_finite(ray.direction));
    CHECK(ray.direction.length() == Approx(1));
}

TEST_CASE("Rays generated together equal those generated one by one, for every instruction set",
          "[render]") {
    for (const double aperture : {0.0, 8.0}) {
        Camera c{Vec3(3, -2, 5), Vec3(0.5, 1, -1), Vec3(0.2, 1, 0.1), 40, aperture, 1.5};
        check_rays_together(CameraRays(c, size));
    }
}
