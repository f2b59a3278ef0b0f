#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "core/scene/scene.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

using Coefficients = std::array<double, 10>;

/// a x^2 + e y^2 + h z^2 + 2i z + j
constexpr Coefficients upright(double a, double e, double h, double i, double j) {
    return {a, 0, 0, 0, e, 0, 0, h, i, j};
}

constexpr Coefficients unit_sphere = upright(1, 1, 1, 0, -1),
                       sphere_of_5 = upright(1, 1, 1, 0, -25);

Scene scene_of(const Quadric& s, Sides sides = Sides::both) {
    Scene scene;
    scene.geometry.add(s, 0, sides);
    return scene;
}

double hit(const Quadric& s, const Ray& ray, Sides sides = Sides::both) {
    return primitive_first_hit(scene_of(s, sides).geometry, 0, RayQuery(ray));
}

bool is_one(double t) {
    return std::abs(t - 1) < 1e-9;
}

/// Returns a quadric about the origin, clipped at `reach` along all axes.
Quadric quadric(const Coefficients& c, double reach) {
    return {{0, 0, 0}, c, {Vec3(-reach), Vec3(reach)}};
}

}  // namespace

TEST_CASE("Quadric: given a sphere, then it is hit where a Sphere is") {
    const Vec3 centre(0.3, -0.7, 0.45);
    const Quadric s{centre, unit_sphere, {centre - Vec3(2), centre + Vec3(2)}};
    Geometry sphere;
    sphere.add(Sphere{centre, 1}, 0);
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 target = centre + 1.2 * random.direction();
        const Ray ray{centre + random.magnitude(-2, 4) * random.direction(), target - centre};
        const double t = hit(s, ray), expected = primitive_first_hit(sphere, 0, RayQuery(ray));
        CAPTURE(i, t, expected);
        REQUIRE(std::isnan(t) == std::isnan(expected));
        if (t <= infinity) REQUIRE(std::abs(t - expected) <= 2 * t_tolerance * expected);
    }
}

TEST_CASE("Quadric: given a first root out of the box, then the second is the hit") {
    Quadric cut = quadric(unit_sphere, 1);
    cut.clip.min.x = 0;
    CHECK(hit(cut, {{-3, 0.5, 0}, {1, 0, 0}}) == Approx(3 + std::sqrt(0.75)));
    CHECK(hit(cut, {{3, 0, 0}, {-1, 0, 0}}) == 2);
    cut.clip.max.x = 0.5;
    CHECK(std::isnan(hit(cut, {{-3, 0, 0}, {1, 0, 0}})));
}

TEST_CASE("Quadric: given a sphere in the least box, then it has no holes where they touch") {
    const Quadric s = quadric(unit_sphere, 1);
    for (int k = 0; k < 3; ++k) {
        for (const double side : {-1.0, 1.0}) {
            Ray in{Vec3(0), Vec3(0)}, out{Vec3(0), Vec3(0)};
            in.origin[k] = 3 * side, in.direction[k] = -side, out.direction[k] = side;
            CHECK(hit(s, in) == 2);
            CHECK(hit(s, out) == 1);
        }
    }
}

TEST_CASE("Quadric: given a root on a face to the last bit, then it is hit, and none beyond") {
    Quadric left = quadric(sphere_of_5, 5), right = left;
    left.clip.max.x = right.clip.min.x = 3;
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 v = 9.0 * random.in_cube();
        const Vec3 p(3, 4, 0), d(std::round(v.x), -1 - std::round(std::abs(v.y)), std::round(v.z));
        if (p.dot(d) >= 0) continue;  // the ray leaves the sphere there
        const Ray exact{p - d, d};
        CAPTURE(i, d);
        CHECK(is_one(hit(left, exact)));
        CHECK(is_one(hit(right, exact)));
        // The point is moved along the sphere, out of one of the boxes.
        const Ray beside{p - d + Vec3(0x1p-48, 0, 0), d};
        const bool in_left = is_one(hit(left, beside)), in_right = is_one(hit(right, beside));
        CHECK(in_left != in_right);
    }
}

TEST_CASE("Quadric: given a side, then the front is where the form is positive") {
    const Ray ray{{0, 0, 3}, {0, 0, -1}};
    for (const double sign : {1.0, -1.0}) {
        const Quadric s = quadric(upright(sign, sign, sign, 0, -sign), 1);
        CHECK(hit(s, ray, Sides::front) == (sign > 0 ? 2 : 4));
        CHECK(hit(s, ray, Sides::back) == (sign > 0 ? 4 : 2));
        CHECK(surface_at(scene_of(s).geometry, ray, {2, 0}).normal.z == sign);
    }
}

TEST_CASE("Quadric: given a line on which the form is linear, then its one root is the hit") {
    const Quadric saddle = quadric({0, 1, 0, 0, 0, 0, 0, 0, -0.5, 0}, 8);  // z = 2xy
    CHECK(hit(saddle, {{2, -4, 4}, {0, 1, 0}}) == 5);
    CHECK(hit(saddle, {{2, 6, 4}, {0, -1, 0}}) == 5);
    const Quadric bowl = quadric(upright(1, 1, 0, -0.5, 0), 4);  // z = x^2 + y^2
    CHECK(hit(bowl, {{1, 1, -3}, {0, 0, 1}}) == 5);
    CHECK(hit(bowl, {{1, 1, 4}, {0, 0, -1}}) == 2);
    const Quadric plane = quadric({0, 0, 0, 0.5, 0, 0, 1, 0, 0, -2}, 4);  // x + 2y = 2
    CHECK(hit(plane, {{0, -3, 0}, {0, 1, 0}}) == 4);
    CHECK(std::isnan(hit(plane, {{0, -3, 0}, {2, -1, 0}})));
}

TEST_CASE("Quadric: given a line in the surface, then it misses") {
    const Quadric cylinder = quadric(upright(1, 1, 0, 0, -25), 9);
    CHECK(std::isnan(hit(cylinder, {{3, 4, -20}, {0, 0, 1}})));
    CHECK(std::isnan(hit(quadric(upright(1, 1, -1, 0, 0), 9), {{3, 4, 5}, {-3, -4, -5}})));
}

TEST_CASE("Quadric: given a tangent to the last bit, then either side is hit, and no line beyond") {
    const Quadric s = quadric(sphere_of_5, 5);
    for (const Sides sides : {Sides::both, Sides::front, Sides::back}) {
        CHECK(hit(s, {{-8, 5, 0}, {1, 0, 0}}, sides) == 8);
        CHECK(hit(s, {{3 - 8, 4 + 6, 0}, {4, -3, 0}}, sides) == 2);
        CHECK(std::isnan(hit(s, {{-8, 5, 0x1p-100}, {1, 0, 0}}, sides)));
        CHECK(std::isnan(hit(s, {{-8, std::nextafter(5, 6), 0}, {1, 0, 0}}, sides)));
    }
}

TEST_CASE(
    "Quadric: given a squared plane, then it is hit once, and not again by a ray that leaves it") {
    // (x + 2y + 2z - 1)^2
    const Quadric doubled = {{0, 0, 0}, {1, 2, 2, -1, 4, 4, -2, 4, -2, 1}, {Vec3(-2), Vec3(2)}};
    const Vec3 n = Vec3(1, 2, 2) / 3.0;
    const Scene scene = scene_of(doubled);
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{3.0 * random.direction(), random.direction()};
        const double t = primitive_first_hit(scene.geometry, 0, RayQuery(ray));
        if (std::isnan(t)) continue;
        CAPTURE(i, t);
        REQUIRE(t == Approx((1.0 / 3 - n.dot(ray.origin)) / n.dot(ray.direction)));
        const SurfacePoint p = surface_at(scene.geometry, ray, {t, 0});
        REQUIRE(std::abs(p.normal.dot(n)) == Approx(1));
        const Ray leaving = spawn_ray(p, random.direction());
        REQUIRE(std::isnan(primitive_first_hit(scene.geometry, 0, RayQuery(leaving))));
    }
}

TEST_CASE("Quadric: given a common factor, then nothing changes but which side is which") {
    const Coefficients c = {0.3, -0.7, 0.2, 0.1, 0.5, 0.4, -0.2, -0.6, 0.3, -0.2};
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{3.0 * random.direction(), random.direction()};
        for (const double factor : {-1.0, 0x1p20, -0x1p-20}) {
            Coefficients other = c;
            for (double& x : other) x *= factor;
            const Sides opposite = factor > 0 ? Sides::front : Sides::back;
            const double t = hit(quadric(c, 1), ray, Sides::front);
            const double same = hit(quadric(other, 1), ray, opposite);
            CAPTURE(i, factor, t, same);
            REQUIRE((t == same || (std::isnan(t) && std::isnan(same))));
        }
    }
}
