#include <algorithm>
#include <numbers>
#include <utility>

#include "core/render/camera_rays.h"
#include "tests/render/rays_together.h"

using namespace etalon;
using namespace etalon::test;

namespace {

Camera projective(const ProjectiveCamera& camera) {
    Camera result{Vec3(7), Vec3(8), Vec3(0, 1, 0)};
    result.projective = camera;
    return result;
}

/// A map that shears and mirrors space; its columns are neither of unit length nor perpendicular.
const Affine bent{{-2, 0, 0.5}, {0.25, 1.5, 0}, {0, 0.5, 3}, {1, -2, 4}};

const ProjectiveCamera bent_camera{
    Projection::perspective, bent, ImageWindow{-1.5, 1, -1, 0.5}, 1, 0.25, 5};

const Imath::V2i size(200, 100);

bool close(const Vec3& a, const Vec3& b, double tolerance = 1e-14) {
    INFO(a << " " << b);
    return (a - b).length() <= tolerance * (1 + b.length());
}

/// Returns the point of the plane z = 1 of camera space that a pixel shows.
Vec3 on_window(const ProjectiveCamera& c, const Vec2& pixel) {
    const Vec2 part = pixel / Vec2(size);
    const ImageWindow w = c.window(size);
    return {w.left + part.x * w.width(), w.top - part.y * w.height(), 1};
}

/// The point on the lens for (1, 0.5), and for (0.5, 1).
const Vec2 lens_right(1, 0.5), lens_up(0.5, 1), lens_middle(0.5, 0.5);

Vec3 ndc_of(const CameraRays& camera, const Vec3& point) {
    Vec3 result;
    camera.world_to_ndc()->multVecMatrix(point, result);
    return result;
}

}  // namespace

TEST_CASE("A perspective camera sees its window in the plane z = 1 of its space", "[render]") {
    ProjectiveCamera c = bent_camera;
    c.lens_radius = 0;
    const CameraRays camera(projective(c), size);
    CHECK(!camera.has_lens());
    for (const Vec2& pixel : {Vec2(0), Vec2(200, 100), Vec2(31.5, 77.25)}) {
        const Ray ray = camera.ray(pixel, lens_middle);
        CHECK(ray.origin == bent.origin);
        CHECK(close(ray.direction, normalized(bent.vector(on_window(c, pixel)))));
    }
}

TEST_CASE("The image of a window whose edges are exchanged is mirrored", "[render]") {
    ProjectiveCamera c = bent_camera;
    c.projection = GENERATE(Projection::perspective, Projection::orthographic);
    c.lens_radius = 0;
    const CameraRays camera(projective(c), size);
    auto& [left, right, bottom, top] = *c.fixed_window;
    std::swap(left, right), std::swap(bottom, top);
    const CameraRays mirrored(projective(c), size);
    for (const Vec2& pixel : {Vec2(0), Vec2(200, 100), Vec2(31.5, 77.25)}) {
        const Ray ray = camera.ray(pixel, lens_middle);
        const Ray same = mirrored.ray(Vec2(size) - pixel, lens_middle);
        CHECK(close(ray.origin, same.origin));
        CHECK(close(ray.direction, same.direction));
        const Vec3 seen = bent.point(3.0 * on_window(bent_camera, pixel));
        const Vec3 ndc = ndc_of(camera, seen);
        CHECK(close(ndc_of(mirrored, seen), {-ndc.x, -ndc.y, ndc.z}, 1e-13));
    }
}

TEST_CASE("Pixels are square in an image of any size if the window is not fixed", "[render]") {
    ProjectiveCamera c = bent_camera;
    c.fixed_window.reset();
    c.half_side = 0.75;
    for (const Imath::V2i& resolution : {Imath::V2i(200, 100), Imath::V2i(50, 75)}) {
        const ImageWindow w = c.window(resolution);
        CHECK(w.width() / resolution.x == Approx(w.height() / resolution.y));
        CHECK(std::min(w.width(), w.height()) == 1.5);
        CHECK(w.left == -w.right);
        CHECK(w.bottom == -w.top);
    }
}

TEST_CASE("A lens lies in the plane z = 0 and its rays converge at the focal distance",
          "[render]") {
    const CameraRays camera(projective(bent_camera), size);
    CHECK(camera.has_lens());
    const Vec2 pixel(31.5, 77.25);
    const Vec3 focus = bent.point(5.0 * on_window(bent_camera, pixel));
    for (const auto& [lens, on_lens] : {std::pair(lens_middle, Vec3(0)),
                                        {lens_right, Vec3(0.25, 0, 0)},
                                        {lens_up, Vec3(0, 0.25, 0)}}) {
        const Ray ray = camera.ray(pixel, lens);
        CHECK(close(ray.origin, bent.point(on_lens)));
        CHECK(close(ray.direction, normalized(focus - ray.origin)));
    }
}

TEST_CASE("An orthographic camera's rays are parallel and begin in its window", "[render]") {
    ProjectiveCamera c = bent_camera;
    c.projection = Projection::orthographic;
    c.lens_radius = 0;
    const CameraRays camera(projective(c), size);
    for (const Vec2& pixel : {Vec2(0), Vec2(200, 100), Vec2(31.5, 77.25)}) {
        const Ray ray = camera.ray(pixel, lens_middle);
        const Vec3 place = on_window(c, pixel);
        CHECK(close(ray.origin, bent.point({place.x, place.y, 0})));
        CHECK(close(ray.direction, normalized(bent.z)));
    }
}

TEST_CASE("All rays of an orthographic camera with a lens begin on the one lens, as in pbrt-v3",
          "[render]") {
    ProjectiveCamera c = bent_camera;
    c.projection = Projection::orthographic;
    const CameraRays camera(projective(c), size);
    const Vec3 place = on_window(c, Vec2(31.5, 77.25));
    const Vec3 focus = bent.point({place.x, place.y, 5});
    const Ray ray = camera.ray(Vec2(31.5, 77.25), lens_right);
    CHECK(close(ray.origin, bent.point({0.25, 0, 0})));
    CHECK(close(ray.direction, normalized(focus - ray.origin)));
}

TEST_CASE("An environment's rows are angles from y and its columns those from x by z", "[render]") {
    ProjectiveCamera c = bent_camera;
    c.projection = Projection::environment;
    const CameraRays camera(projective(c), size);
    CHECK(!camera.has_lens());
    CHECK(!camera.world_to_ndc());
    const double diagonal = std::sqrt(0.5);
    for (const auto& [pixel, direction] : {std::pair(Vec2(0, 50), Vec3(1, 0, 0)),
                                           {Vec2(50, 50), Vec3(0, 0, 1)},
                                           {Vec2(100, 50), Vec3(-1, 0, 0)},
                                           {Vec2(150, 50), Vec3(0, 0, -1)},
                                           {Vec2(77, 0), Vec3(0, 1, 0)},
                                           {Vec2(77, 100), Vec3(0, -1, 0)},
                                           {Vec2(50, 25), Vec3(0, diagonal, diagonal)},
                                           {Vec2(25, 50), Vec3(diagonal, 0, diagonal)}}) {
        const Ray ray = camera.ray(pixel, lens_right);
        CHECK(ray.origin == bent.origin);
        CHECK(close(ray.direction, normalized(bent.vector(direction))));
    }
}

TEST_CASE("A pinhole or lens camera by its own space has the same rays", "[render]") {
    const Camera plain{Vec3(3, -2, 5), Vec3(0.5, 1, -1), Vec3(0.2, 1, 0.1), 40, 8, 1.5};
    const CameraRays camera(plain, size);
    const Vec3 back = plain.eye - plain.at, n = normalized(back);
    const Vec3 right = normalized(plain.up.cross(n)), up = n.cross(right);
    const double slope = std::tan(20 * std::numbers::pi / 180), distance = back.length();
    const Affine to_world{right, up, -n, plain.eye};
    const CameraRays same(projective({Projection::perspective, to_world, std::nullopt, slope,
                                      8 * (2 * distance * slope / size.y) / 2, 1.5 * distance}),
                          size);
    for (int i = 0; i < 50; ++i) {
        const Vec2 pixel(i * 4.1, 100 - i * 1.9), lens(i * 7 % 50 / 50.0, i / 50.0);
        const Ray a = camera.ray(pixel, lens), b = same.ray(pixel, lens);
        CHECK(close(a.origin, b.origin, 1e-15));
        CHECK(close(a.direction, b.direction, 4e-15));
    }
    const Vec3 point(0.3, 0.7, -2);
    CHECK(camera.depth(point) == Approx(same.depth(point)));
    CHECK(close(ndc_of(camera, point), ndc_of(same, point), 1e-13));
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            CHECK(camera.world_to_camera()[i][k] ==
                  Approx(same.world_to_camera()[i][k]).margin(1e-14));
        }
    }
}

TEST_CASE("world_to_ndc maps a point seen by any pixel to the pixel's position", "[render]") {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        ProjectiveCamera c = bent_camera;
        c.projection = projection;
        c.lens_radius = 0;
        const CameraRays camera(projective(c), size);
        for (const double distance : {1.0, 7.0}) {
            const Ray ray = camera.ray(Vec2(50, 25), lens_middle);
            const Vec3 ndc = ndc_of(camera, ray.origin + distance * ray.direction);
            CHECK(ndc.x == Approx(-0.5));
            CHECK(ndc.y == Approx(0.5));
        }
    }
}

TEST_CASE("world_to_camera is camera space with z backwards", "[render]") {
    const CameraRays camera(projective(bent_camera), size);
    Vec3 seen;
    camera.world_to_camera().multVecMatrix(bent.point({2, -3, 5}), seen);
    CHECK(close(seen, {2, -3, -5}, 1e-13));
}

TEST_CASE("Depth is perpendicular to the image plane, in the world's lengths", "[render]") {
    const Affine doubled{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, 1}};
    ProjectiveCamera c{Projection::perspective, doubled, std::nullopt, 1, 0, 1};
    CHECK(CameraRays(projective(c), size).depth({3, 4, 7}) == 6);
    c.to_world.x = {-2, 0, 0};
    CHECK(CameraRays(projective(c), size).depth({3, 4, -7}) == -8);
    c.to_world.z = {1, 0, 2};
    CHECK(CameraRays(projective(c), size).depth({3, 4, 7}) == 6);
    c.projection = Projection::environment;
    CHECK(CameraRays(projective(c), size).depth({0, 4, -2}) == 5);
}

TEST_CASE("Projective rays made together are those made one by one", "[render]") {
    for (const Projection projection :
         {Projection::perspective, Projection::orthographic, Projection::environment}) {
        ProjectiveCamera c = bent_camera;
        c.projection = projection;
        check_rays_together(CameraRays(projective(c), size));
    }
}
