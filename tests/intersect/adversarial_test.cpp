#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"
#include "tests/intersect/scene_numbers.h"

using namespace etalon;

namespace {

constexpr double adversarial_numbers[] = {nan_value, infinity, -infinity};

bool is_hit(const Scene& scene, const Ray& ray) {
    const double t = primitive_first_hit(scene.geometry, 0, RayQuery(ray));
    return t > ray.tmin || t == infinity;
}

/// Returns a ray through or near the origin, from all around.
Ray probing_ray(int i, Random& random) {
    const Vec3 target = i % 3 == 0   ? Vec3(0)
                        : i % 3 == 1 ? Vec3(random.uniform(-2, 4), 0, 0)
                                     : random.in_cube();
    Vec3 direction = random.direction();
    if (i % 5 == 0) direction = Vec3(i % 2 == 0 ? 1 : 0, i % 2 == 0 ? 0 : 1, 0);
    return {target - random.uniform(0, 10) * direction, direction};
}

}  // namespace

TEST_CASE("Kernels: given a degenerate shape, then nothing hits it") {
    for (const DegenerateCase& shape : degenerate_cases()) {
        CAPTURE(shape.name);
        const Box3 box = primitive_bounds(shape.scene.geometry, 0);
        REQUIRE((box.isEmpty() || !shape.empty_bounds));
        Random random(6);
        for (int i = 0; i < 2000; ++i) {
            const Ray ray = probing_ray(i, random);
            CAPTURE(i, ray.origin, ray.direction);
            REQUIRE_FALSE(is_hit(shape.scene, ray));
        }
    }
}

TEST_CASE("Kernels: given a shape with a number that is none, then nothing hits it") {
    for (const ShapeCase& shape : shape_cases()) {
        Scene scene = shape.scene;
        for (double* number : numbers_of(scene)) {
            const double original = *number;
            for (const double adversarial : adversarial_numbers) {
                *number = adversarial;
                finalize(scene);
                CAPTURE(shape.name, adversarial);
                REQUIRE(primitive_bounds(scene.geometry, 0).isEmpty());
                Random random(7);
                for (int i = 0; i < 100; ++i) {
                    REQUIRE_FALSE(is_hit(scene, aimed_ray(shape, i, random).ray));
                }
            }
            *number = original;
        }
    }
}

TEST_CASE(
    "Kernels: given a ray with a number that is none, then t is none or finite all the same") {
    // Intersector rejects such rays, so a kernel need only not crash.
    for (const ShapeCase& shape : shape_cases()) {
        Random random(8);
        for (int i = 0; i < 200; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            for (int k = 0; k < 6; ++k) {
                for (const double adversarial : adversarial_numbers) {
                    Ray bad = ray;
                    (k < 3 ? bad.origin : bad.direction)[k % 3] = adversarial;
                    CAPTURE(shape.name, i, k, adversarial);
                    REQUIRE(std::abs(primitive_first_hit(shape.scene.geometry, 0, RayQuery(bad))) !=
                            infinity);
                }
            }
            CAPTURE(shape.name, i);
            REQUIRE_FALSE(is_hit(shape.scene, {ray.origin, Vec3(0)}));
        }
    }
}

TEST_CASE("Kernels: given any hit, then t is finite and the point has all its numbers") {
    for (const ShapeCase& shape : shape_cases()) {
        Random random(9);
        for (int i = 0; i < 1000; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
            CAPTURE(shape.name, i, t);
            REQUIRE((std::isnan(t) || (t > ray.tmin && t < infinity)));
            if (std::isnan(t)) continue;
            const SurfacePoint p = surface_at(shape.scene.geometry, ray, {t, 0});
            REQUIRE(is_finite(p.position));
            REQUIRE(is_finite(p.error));
            REQUIRE(p.normal.length() == Approx(1).epsilon(1e-12));
            REQUIRE(p.shading_normal.length() == Approx(1).epsilon(1e-12));
        }
    }
}

namespace {

double sphere_hit(const Sphere& sphere, const Ray& ray) {
    Scene scene;
    scene.geometry.add(sphere, 0);
    return primitive_first_hit(scene.geometry, 0, RayQuery(ray));
}

}  // namespace

TEST_CASE("Spheres: given numbers that are none among tiny ones, then nothing hits") {
    const Ray ray{Vec3(-5, 0, 0), Vec3(1, 1e-200, 0)};
    for (const double x : {nan_value, infinity}) {
        CHECK(std::isnan(sphere_hit({{0, x, 1e-300}, 1}, ray)));
        CHECK(std::isnan(sphere_hit({{0, 1e-300, 0}, nan_value}, ray)));
        CHECK(std::isnan(sphere_hit({{0, 1e-300, 0}, 1}, {Vec3(x, 1e-300, 0), ray.direction})));
    }
}

TEST_CASE("Spheres: given a ray from any distance, then hit and miss are exact") {
    const Vec3 direction(3, 4, 0), across(4, -3, 0);
    for (int k = 60; k < 960; k += 20) {
        CAPTURE(k);
        const Vec3 origin = std::ldexp(-1, k) * direction;
        const Vec3 beside(std::nextafter(origin.x, 0), origin.y, 0);
        const double t = std::ldexp(1, k);
        REQUIRE(sphere_hit({{0, 0, 0}, 1}, {origin, direction}) == t);
        REQUIRE(std::isnan(sphere_hit({{0, 0, 0}, 1}, {beside, direction})));
        REQUIRE(sphere_hit({across, 5}, {origin, direction}) == t);
        REQUIRE(std::isnan(sphere_hit({across, std::nextafter(5, 0)}, {origin, direction})));
        REQUIRE(sphere_hit({0x1p-200 * across, 5 * 0x1p-200}, {origin, direction}) == t);
    }
}

TEST_CASE("Flat shapes: given a ray from any distance, then hit and miss are exact") {
    Scene scene;
    for (const Vec3& v : {Vec3(4, -3, -9), Vec3(4, -3, 9), Vec3(-4, 3, 0)}) {
        scene.geometry.add_vertex(v);
    }
    scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    const std::array corners = {Vec3(4, -3, -9), Vec3(4, -3, 9), Vec3(-4, 3, 0)};
    scene.geometry.add(Polygon{corners}, 0);
    for (int k = 60; k < 960; k += 20) {
        const Vec3 direction(3, 4, 0), origin = std::ldexp(-1, k) * direction;
        for (const std::uint32_t primitive : {0U, 1U}) {
            CAPTURE(k, primitive);
            const auto hit = [&](const Vec3& from) {
                return primitive_first_hit(scene.geometry, primitive,
                                           RayQuery(Ray{from, direction}));
            };
            REQUIRE(hit(origin) == std::ldexp(1, k));
            REQUIRE(hit(-std::ldexp(1, -k) * direction) == std::ldexp(1, -k));
            REQUIRE(std::isnan(hit({std::nextafter(origin.x, 0), origin.y, 0})));
            REQUIRE(std::isnan(hit({origin.x, std::nextafter(origin.y, 0), 0})));
            REQUIRE(std::isnan(hit({origin.x, origin.y, 10})));
        }
    }
}

TEST_CASE(
    "Kernels: given a ray that passes an edge by less than any double, then hit and miss are "
    "exact") {
    Scene scene;
    for (const Vec3& v : {Vec3(0), Vec3(0, 1, 1), Vec3(-1, 0, 0), Vec3(1, 0, 0)}) {
        scene.geometry.add_vertex(v);
    }
    scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    scene.geometry.add(Triangle{{0, 1, 3}}, 0);
    scene.geometry.add(Box{{1, -1, -1}, {2, 0, 1}}, 0);
    const auto is_hit = [&](std::uint32_t primitive, const Vec3& from, const Vec3& towards) {
        return primitive_first_hit(scene.geometry, primitive, RayQuery(Ray{from, towards})) > 0;
    };
    const double slow = 0x1p-400, near = 0x1p-900;
    // Through the vertex, or past it: above it both edges are next to the ray.
    for (const std::uint32_t triangle : {0U, 1U}) {
        CAPTURE(triangle);
        CHECK(is_hit(triangle, {-slow, -1, 0}, {slow, 1, 0}));
        CHECK(is_hit(triangle, {-slow, -1, near}, {slow, 1, 0}) == (triangle == 1));
        CHECK_FALSE(is_hit(triangle, {-slow, -1, -near}, {slow, 1, 0}));
    }
    CHECK(is_hit(2, {near, -slow, 0}, {1, slow, 0}));
    CHECK(is_hit(2, {0, -slow, 0}, {1, slow, 0}));
    CHECK_FALSE(is_hit(2, {-near, -slow, 0}, {1, slow, 0}));
}

TEST_CASE(
    "Flat shapes: given a ray that begins so near their point that products underflow, then its "
    "side is exact") {
    Scene scene;
    const Vec3 x(0.8, -0.6, 0), y(0.48, 0.64, -0.6), normal(0.36, 0.48, 0.8);
    scene.geometry.add(Plane{Vec3(0), 0x1p-66 * normal}, 0);
    scene.geometry.add(Ring{Vec3(0), 0x1p-66 * normal, 0, 1}, 0);
    const Profile disk{.along = Profile::Along::radius, .high = 1};
    scene.geometry.add(Revolved({x, y, normal, Vec3(0)}, disk, Sector(360)), 0);
    const auto primitive = GENERATE(0U, 1U, 2U);
    Random random(14);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 in_plane = random.uniform(-1, 1) * x + random.uniform(-1, 1) * y;
        const auto is_hit = [&](const Vec3& from, const Vec3& towards) {
            const RayQuery query(Ray{from, towards});
            return primitive_first_hit(scene.geometry, primitive, query) > 0;
        };
        // Scaled up by a power of two, the same ray is far from underflow.
        const Vec3 near = 0x1p-960 * in_plane, far = 0x1p-100 * in_plane;
        CAPTURE(i, primitive, in_plane);
        REQUIRE(is_hit(near, normal) == is_hit(far, normal));
        REQUIRE(is_hit(near, -normal) == is_hit(far, -normal));
    }
}

TEST_CASE("Flat shapes: given a ray that begins next to their plane, then t is exact") {
    Scene scene;
    const std::array corners = {Vec3(0, 4, -3), Vec3(0, 4, 5), Vec3(0, -4, 5), Vec3(0, -4, -3)};
    for (const Vec3& v : corners) scene.geometry.add_vertex(v);
    scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    scene.geometry.add(Polygon{corners}, 0);
    for (int k = 0; k < 1000; k += 20) {
        for (const Vec3& to : {Vec3(0, 1, 3), Vec3(0, 4, 0), Vec3(0, 4, 5)}) {
            const double step = std::ldexp(1, -k);
            const Ray ray{to - Vec3(step, 0, 0), {1, 0, 0}}, leaving{ray.origin, {-1, 0, 0}};
            const Ray small{ray.origin, {step, 0, 0}}, aslant{ray.origin, {0x1p-60, -1, 0}};
            for (const std::uint32_t primitive : {0U, 1U}) {
                CAPTURE(k, to, primitive);
                const auto hit = [&](const Ray& r) {
                    return first_hit(scene.geometry, key_of(primitive, no_index), r);
                };
                REQUIRE(hit(ray) == step);
                REQUIRE(hit(small) == 1);
                REQUIRE(std::isnan(hit(leaving)));
                REQUIRE((k < 60 || hit(aslant) == 0x1p60 * step));
            }
        }
    }
}
