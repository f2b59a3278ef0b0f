#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "core/scene/scene.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

double hit(const Ring& ring, const Ray& ray, Sides sides = Sides::both) {
    Scene scene;
    scene.geometry.add(ring, 0, sides);
    return primitive_first_hit(scene.geometry, 0, RayQuery(ray));
}

const Ring upright{{0, 0, 0}, {0, 0, 2}, 5, 10};

/// Points with integer coordinates on the inner circle, and on the outer one.
const Vec3 on_inner[] = {{3, 4, 0}, {-4, 3, 0}, {5, 0, 0}, {0, -5, 0}};

}  // namespace

TEST_CASE("Ring: given rays through the hole, the ring and past it, then only the ring is hit") {
    for (const double x : {0.0, 4.5, 10.5}) {
        CHECK(std::isnan(hit(upright, {{x, 0, 3}, {0, 0, -1}})));
    }
    CHECK(hit(upright, {{7, 0, 3}, {0, 0, -1}}) == 3);
    CHECK(hit(upright, {{0, -7, -3}, {0, 0, 0.5}}) == 6);
}

TEST_CASE("Ring: given rays through points of the circles, then they are hit, and none beyond") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 v = 9.0 * random.in_cube();
        const Vec3 d(std::round(v.x), std::round(v.y), 1 + std::round(std::abs(v.z)));
        for (const Vec3& p : on_inner) {
            const Vec3 step = p * 0x1p-50;
            CAPTURE(i, p, d);
            CHECK(hit(upright, {p - d, d}) == 1);
            CHECK(hit(upright, {2.0 * p - d, d}) == 1);
            CHECK(std::isnan(hit(upright, {p - d, d - step})));
            CHECK(std::isnan(hit(upright, {2.0 * p - d, d + step})));
        }
    }
}

TEST_CASE("Ring: given equal radii, then nothing but the circle is hit") {
    const Ring circle{{0, 0, 0}, {0, 0, 1}, 5, 5};
    for (const Vec3& p : on_inner) {
        const Vec3 d(1, 2, 3);
        CHECK(hit(circle, {p - d, d}) == 1);
        CHECK(std::isnan(hit(circle, {p - d, d + p * 0x1p-50})));
        CHECK(std::isnan(hit(circle, {p - d, d - p * 0x1p-50})));
    }
}

TEST_CASE("Ring: given no hole, then the centre is hit") {
    const Ring disc{{1, 2, 3}, {0.1, 0.2, 0.3}, 0, 1};
    CHECK(hit(disc, {{1, 2, 5}, {0, 0, -1}}) == 2);
}

TEST_CASE("Ring: given a side, then it is seen from where the normal points") {
    const Ray from_above{{7, 0, 3}, {0, 0, -1}}, from_below{{7, 0, -3}, {0, 0, 1}};
    CHECK(hit(upright, from_above, Sides::front) == 3);
    CHECK(std::isnan(hit(upright, from_below, Sides::front)));
    CHECK(std::isnan(hit(upright, from_above, Sides::back)));
    CHECK(hit(upright, from_below, Sides::back) == 3);
}

TEST_CASE("Ring: given rays in its plane, then they miss") {
    CHECK(std::isnan(hit(upright, {{-20, 7, 0}, {1, 0, 0}})));
    CHECK(std::isnan(hit(upright, {{7, 0, 0}, {1, 0, 0}})));
}
