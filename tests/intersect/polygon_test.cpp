#include "core/intersect/shapes/polygon.h"

#include <numbers>

#include "core/scene/scene.h"

#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// A plus sign, with four concave corners.
const std::vector<Vec3> plus_sign = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 1, 0},
                                     {3, 2, 0}, {2, 2, 0}, {2, 3, 0}, {1, 3, 0},
                                     {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}};

Scene polygon_scene(const std::vector<Vec3>& corners) {
    Scene scene;
    scene.geometry.add(Polygon{corners}, 0);
    return scene;
}

double hit(const Scene& scene, const Ray& ray, std::uint32_t id = 0) {
    return primitive_first_hit(scene.geometry, id, RayQuery(ray));
}

bool is_hit(const Scene& scene, const Ray& ray, std::uint32_t id = 0) {
    return hit(scene, ray, id) <= infinity;
}

}  // namespace

TEST_CASE("Polygon: given a plus sign, then its arms are hit and its notches are not") {
    const Scene scene = polygon_scene(plus_sign);
    for (const Vec3& d : {Vec3(0, 0, -1), Vec3(0.25, -0.5, -1), Vec3(-0.5, 0.25, -0.25)}) {
        for (int i = -1; i <= 12; ++i) {
            for (int j = -1; j <= 12; ++j) {
                // Multiples of 1/4, which include the outline and its corners exactly.
                const double x = 0.25 * i, y = 0.25 * j;
                const bool column = x >= 1 && x <= 2 && y >= 0 && y <= 3;
                const bool row = y >= 1 && y <= 2 && x >= 0 && x <= 3;
                CAPTURE(x, y, d);
                REQUIRE(is_hit(scene, {Vec3(x, y, 0) - d, d}) == (column || row));
                REQUIRE(is_hit(scene, {Vec3(x, y, 0) + d, -d}) == (column || row));
            }
        }
    }
}

TEST_CASE("Polygon: given a ray in its plane, then it misses") {
    const Scene scene = polygon_scene(plus_sign);
    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 0.5, 0), Vec3(-1, 1, 0)}) {
        for (const Vec3& through : {Vec3(1.5, 1.5, 0), Vec3(1, 1, 0), Vec3(0, 1.5, 0)}) {
            CAPTURE(d, through);
            REQUIRE_FALSE(is_hit(scene, {through - 5.0 * d, d}));
        }
    }
}

TEST_CASE("Polygon: given one across an axis, then t is correctly rounded") {
    const Scene scene = polygon_scene({{-9, -9, 0.1}, {9, -9, 0.1}, {9, 9, 0.1}, {-9, 9, 0.1}});
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 origin = random.in_cube() + Vec3(0, 0, 3), direction = random.direction();
        const double t = (0.1 - origin.z) / direction.z;
        if (direction.z > -0.5) continue;
        REQUIRE(hit(scene, {origin, direction}) == t);
    }
}

TEST_CASE("Polygon: given a quad or its two triangles, then the same rays hit") {
    Scene scene;
    Random random(14);
    scene.geometry.vertices = {
        {0, 0, 0}, {2, 0.5, 0}, {2.5, 2, 0}, {0.5, 1.5, 0}};  // a parallelogram
    scene.geometry.add(Polygon{scene.geometry.vertices}, 0);
    scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    scene.geometry.add(Triangle{{0, 2, 3}}, 0);
    for (int i = 0; i < 20000; ++i) {
        const auto k = static_cast<std::size_t>(random.index(4));
        const Vec3 &a = scene.geometry.vertices[k],
                   &b = scene.geometry.vertices[(k + 1 + i % 2) % 4];
        const Vec3 origin = 3.0 * random.in_cube();
        const Ray ray{origin, a + random.uniform() * (b - a) - origin};
        CAPTURE(i, ray.origin, ray.direction);
        REQUIRE(is_hit(scene, ray, 0) == (is_hit(scene, ray, 1) || is_hit(scene, ray, 2)));
    }
}

TEST_CASE("Polygon: given corners a little off the plane, then the hit is on it, within its box") {
    const Scene scene = polygon_scene({{0, 0, 1e-6}, {2, 0, -1e-6}, {2, 1, 1e-6}, {0, 1, -1e-6}});
    Random random(15);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 target(2 * random.uniform(), random.uniform(), 0);
        const Vec3 direction = random.direction();
        const Ray ray{target - 3.0 * direction, direction};
        const double t = hit(scene, ray);
        if (!(t <= infinity)) continue;
        const Vec3 point = ray.origin + t * direction;
        CAPTURE(point);
        REQUIRE(std::abs(point.z) <= 1.000001e-6);
        REQUIRE(surface_at(scene.geometry, ray, {t, 0}).normal.dot(Vec3(0, 0, 1)) > 0.999999);
    }
}

TEST_CASE(
    "interpolated_normal: given normals that vary linearly, then they are reproduced everywhere") {
    // Mean value coordinates reproduce linear functions, in concave polygons too.
    const auto field = [](const Vec3& p) {
        return Vec3(0.3 * p.x - 0.1, 0.2 * p.y + 0.1 * p.x, 1);
    };
    std::vector<Vec3> normals;
    for (const Vec3& p : plus_sign) normals.push_back(field(p));
    const Vec3 up(0, 0, 1);
    const auto require_field = [&](const Vec3& p) {
        const Vec3 n = interpolated_normal(plus_sign, normals, up, p);
        CAPTURE(p, n);
        REQUIRE((n / n.z - field(p)).length() < 1e-12);
    };
    Random random(16);
    for (int i = 0; i < 1000; ++i) {
        require_field({1 + random.uniform(), 3 * random.uniform(), 0});
        require_field({3 * random.uniform(), 1 + random.uniform(), 0});
    }
    for (std::size_t k = 0; k < plus_sign.size(); ++k) {
        const Vec3 &a = plus_sign[k], &b = plus_sign[(k + 1) % plus_sign.size()];
        require_field(a);
        for (const double s : {0.5, 0.25, 1e-9, 1 - 1e-9}) require_field(a + s * (b - a));
    }
}

TEST_CASE(
    "Polygon: given corner normals that cancel, then the shading normal is the geometric one") {
    const std::vector<Vec3> corners = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    const std::vector<Vec3> normals = {{1, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    Scene scene;
    scene.geometry.add(Polygon{corners, normals}, 0);
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    const SurfacePoint p = surface_at(scene.geometry, ray, {hit(scene, ray), 0});
    REQUIRE(p.shading_normal == p.normal);
    REQUIRE(p.normal == Vec3(0, 0, 1));
}

TEST_CASE("Polygon: given corners whose normal vanishes in double only, then it is hit") {
    // Collinear corners, up to rounding.
    const Scene scene = polygon_scene({{1.69, -1.89, -2.36},
                                       {1.69, 8.86, 2.9},
                                       {1.69, 6.1725, 1.585},
                                       {1.69, 19.61, 8.16},
                                       {1.69, 8.86, 2.9}});
    Vec3 normal(0);
    const auto corners = scene.geometry.all<Polygon>()[0].corners;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        normal += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    }
    CHECK(normal == Vec3(0));
    CHECK_FALSE(primitive_bounds(scene.geometry, 0).isEmpty());
    const SurfacePoint p = surface_at(scene.geometry, {{0, 8.86, 2.9}, {1, 0, 0}}, {1.69, 0});
    CHECK(is_finite(p.normal));
}

TEST_CASE("Polygon: given many corners in a tilted plane, rays that leave it need no exact sums") {
    for (const int count : {7, 100, 1000}) {
        std::vector<Vec3> corners;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count, x = std::cos(angle);
            corners.push_back({x, std::sin(angle), 0.3 * x});
        }
        const Scene scene = polygon_scene(corners);
        const StoredPolygon polygon = scene.geometry.all<Polygon>()[0];
        Random random(6);
        for (int i = 0; i < 100; ++i) {
            const Vec3 place = 0.5 * random.in_cube();
            const Ray ray{{place.x, place.y, 3}, {0, 0, -1}};
            const SurfacePoint point = surface_at(scene.geometry, ray, {hit(scene, ray), 0});
            const Ray leaving = spawn_ray(point, random.direction());
            CHECK(plain_passage(polygon, RayQuery(leaving)).has_value());
        }
    }
}
