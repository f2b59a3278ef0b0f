// Polar decomposition of maps into rotations and stretches, and rotations as quaternions.
#include "core/numerics/polar.h"

#include "core/numerics/quaternion.h"
#include "core/numerics/random.h"
#include "core/numerics/transforms.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

double difference(const Affine& a, const Affine& b) {
    return std::max({max_abs(a.x - b.x), max_abs(a.y - b.y), max_abs(a.z - b.z)});
}

Vec3 any_direction(Random& random) {
    return normalized(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.01, 1)));
}

Affine any_rotation(Random& random) {
    return rotation(random.uniform(-360, 360), any_direction(random));
}

}  // namespace

TEST_CASE("polar_parts: given a stretch before a rotation, then both are found") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Affine turn = any_rotation(random), axes = any_rotation(random);
        const Vec3 factors(random.uniform(0.1, 10), random.uniform(0.1, 10), 1);
        const Affine back{{axes.x.x, axes.y.x, axes.z.x},
                          {axes.x.y, axes.y.y, axes.z.y},
                          {axes.x.z, axes.y.z, axes.z.z}};
        const Affine stretch = axes * scaling(factors) * back;
        const PolarParts parts = polar_parts(turn * stretch);
        CAPTURE(i);
        REQUIRE(difference(parts.rotation, turn) < 1e-13);
        REQUIRE(difference(parts.stretch, stretch) < 1e-12);
    }
}

TEST_CASE("polar_parts: given a map that mirrors, then the stretch does and the rotation not") {
    const Affine map = rotation(40, {1, 2, 3}) * scaling({-1, 2, 3});
    const PolarParts parts = polar_parts(map);
    CHECK(parts.rotation.determinant() == Approx(1));
    CHECK(parts.stretch.determinant() == Approx(-6));
    CHECK(difference(parts.rotation * parts.stretch, map) < 1e-14);
}

TEST_CASE("polar_parts: given scales of any size, then the rotation has the same bits") {
    const Affine map = rotation(40, {1, 2, 3}) * scaling({1, 2, 300});
    const Affine small = map * scaling(Vec3(0x1p-500));
    CHECK(polar_parts(map).rotation == polar_parts(small).rotation);
    CHECK(std::isnan(polar_parts(scaling({1, 0, 1})).rotation.x.x));
}

TEST_CASE("Quaternion: given a rotation, then its quaternion gives it back") {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Affine turn = any_rotation(random);
        const Quaternion q = quaternion_of(turn);
        REQUIRE(q.dot(q) == Approx(1).epsilon(1e-14));
        REQUIRE(difference(rotation_of(q), turn) < 1e-14);
    }
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        CHECK(difference(rotation_of(quaternion_of(rotation(180, axis))), rotation(180, axis)) ==
              0);
    }
}
