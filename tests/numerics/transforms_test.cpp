#include "core/numerics/transforms.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

bool near(const Vec3& a, const Vec3& b, double tolerance = 1e-14) {
    return max_abs(a - b) <= tolerance * std::max(1.0, max_abs(b));
}

Affine random_map(Random& random) {
    const Vec3 x = random.in_cube(), y = random.in_cube(), z = random.in_cube();
    return {x, y, z, random.in_cube()};
}

/// Returns a random rotation whose numbers are rounded to float.
Affine float_rotation(Random& random) {
    Affine map = rotation(random.uniform(0, 360), random.direction());
    for (Vec3* column : {&map.x, &map.y, &map.z}) *column = Vec3(Vec3f(*column));
    return map;
}

}  // namespace

TEST_CASE("a quarter turn is right-handed and exact") {
    const Affine about_x = rotation(90, {1, 0, 0});
    CHECK(about_x.x == Vec3(1, 0, 0));
    CHECK(about_x.y == Vec3(0, 0, 1));
    CHECK(about_x.z == Vec3(0, -1, 0));
    CHECK(rotation(90, {0, 3, 0}).z == Vec3(1, 0, 0));
    CHECK(rotation(90, {0, 0, 1e-300}).x == Vec3(0, 1, 0));
    for (const double degrees : {-270.0, 450.0, 90.0 + 360e9}) {
        CHECK(rotation(degrees, {1, 0, 0}).y == Vec3(0, 0, 1));
    }
    CHECK(rotation(180, {0, 0, 1}).x == Vec3(-1, 0, 0));
    CHECK(rotation(-90, {0, 0, 1}).x == Vec3(0, -1, 0));
    CHECK(rotation(0, {1, 2, 3}).x == Vec3(1, 0, 0));
}

TEST_CASE("a rotation leaves its axis and turns the rest by its angle") {
    const Affine third = rotation(120, {1, 1, 1});
    CHECK(near(third.x, {0, 1, 0}));
    CHECK(near(third.y, {0, 0, 1}));
    const Affine m = rotation(25, {1, 2, -3});
    CHECK(near(m.vector({1, 2, -3}), {1, 2, -3}));
    CHECK(m.determinant() == Approx(1).epsilon(1e-14));
    CHECK(m.x.x + m.y.y + m.z.z == Approx(1 + 2 * std::cos(25 * M_PI / 180)).epsilon(1e-14));
}

TEST_CASE("maps act from the right: the one nearest the point first") {
    const Affine m = translation({1, 0, 0}) * rotation(90, {0, 0, 1}) * scaling({2, 3, 4});
    CHECK(m.point({1, 1, 1}) == Vec3(-2, 2, 4));
}

TEST_CASE("a map is singular where its volume is lost in roundings, however uneven its scales") {
    CHECK(is_singular(scaling({1, 1, 0})));
    CHECK(is_singular(Affine{{1, 2, 3}, {4, 5, 6}, {5, 7, 9}}));
    CHECK(is_singular(rotation(30, {1, 2, 3}) * scaling({1, 0, 1}) * rotation(50, {3, 2, 1})));
    CHECK(is_singular(Affine{{nan_value, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    CHECK_FALSE(is_singular(Affine{}));
    CHECK_FALSE(is_singular(scaling({1e-200, 1e200, -1e-300})));
    CHECK_FALSE(is_singular(rotation(30, {1, 2, 3}) * scaling({1, 1e-30, 1})));
    CHECK_FALSE(is_singular(scaling({1, 1e-30, 1}) * rotation(30, {1, 2, 3})));
}

TEST_CASE("a map mirrors if its determinant is negative, however small") {
    CHECK_FALSE(mirrors(scaling({1e-200, 1e-200, 1e-200})));
    CHECK(mirrors(scaling({1e-200, -1e-200, 1e-200})));
    CHECK_FALSE(mirrors(rotation(77, {1, -2, 3})));
}

TEST_CASE("normals stay perpendicular to what they stood on, on its outside") {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const Affine m = random_map(random);
        const auto [a, b, out, unused] = random_map(random);
        const Vec3 normal = a.cross(b) * (a.cross(b).dot(out) < 0 ? -1 : 1);
        const Vec3 moved = NormalMap(m)(normal);
        CHECK(std::abs(moved.dot(m.vector(a))) < 1e-14 * max_abs(moved));
        CHECK(std::abs(moved.dot(m.vector(b))) < 1e-14 * max_abs(moved));
        CHECK(moved.dot(m.vector(out)) > 0);
    }
}

TEST_CASE("a product of rotations and one scale has a scale, if rounded to float, but no more") {
    Random random(8, 0);
    for (int i = 0; i < 1000; ++i) {
        const double factor = random.magnitude(-6, 6);
        const Affine map = float_rotation(random) * float_rotation(random) * scaling(Vec3(factor)) *
                           float_rotation(random) * float_rotation(random);
        REQUIRE(scale_of(map));
        REQUIRE(std::abs(*scale_of(map) / factor - 1) < 5e-7);
        const Affine uneven = map * scaling({1, 1, 1.000004});
        REQUIRE_FALSE(scale_of(uneven));
    }
}
