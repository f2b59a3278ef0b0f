#include "core/numerics/local_frame.h"

#include "core/numerics/random.h"
#include "core/numerics/rounding.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// Two of the columns differ by 10^-exponent only.
Affine nearly_singular(double exponent, Random& random) {
    const Vec3 x = random.in_cube(), z = random.in_cube();
    return {x, x + std::pow(10.0, -exponent) * random.in_cube(), z, random.in_cube()};
}

/// The image of an axis, of the shape as it is turned.
Vec3 column(const LocalFrame& frame, const Affine& map, int k) {
    Vec3 axis(0);
    axis[k] = 1;
    return frame.point(axis) - map.origin;
}

}  // namespace

TEST_CASE("LocalFrame: given maps of any condition, then it undoes them to the last bits") {
    Random random(20261122);
    for (int i = 0; i < 1000; ++i) {
        Affine map = nearly_singular(i % 13, random);
        map.origin = Vec3(0);
        for (const Symmetry symmetry : {Symmetry::sphere, Symmetry::about_z}) {
            const LocalFrame frame(map, symmetry);
            REQUIRE(frame.exists());
            for (int k = 0; k < 9; ++k) {
                const Vec3 &row = frame.row(k / 3), axis = column(frame, map, k % 3);
                const double error = std::abs(row.dot(axis) - (k / 3 == k % 3 ? 1 : 0));
                CAPTURE(i, k, row, axis);
                REQUIRE(error <= 8 * unit_roundoff * row.length() * axis.length());
            }
        }
    }
}

TEST_CASE("LocalFrame: given any map, then the rows that may be turned are at right angles") {
    Random random(20261122);
    const auto cosine = [](const Vec3& a, const Vec3& b) {
        return std::abs(a.normalized().dot(b.normalized()));
    };
    for (int i = 0; i < 1000; ++i) {
        const Affine map = nearly_singular(i % 13, random);
        const LocalFrame sphere(map, Symmetry::sphere), round(map, Symmetry::about_z);
        CAPTURE(i);
        REQUIRE(cosine(sphere.row(0), sphere.row(1)) < 0x1p-9);
        REQUIRE(cosine(sphere.row(1), sphere.row(2)) < 0x1p-9);
        REQUIRE(cosine(sphere.row(2), sphere.row(0)) < 0x1p-9);
        REQUIRE(cosine(round.row(0), round.row(1)) < 0x1p-9);
        // The axis of a shape that is rotationally symmetric about z does not change.
        REQUIRE((column(round, map, 2) - map.z).length() <= 4 * unit_roundoff);
    }
}

TEST_CASE("LocalFrame: given lengths of rows, then they are no shorter than the rows") {
    Random random(20261122);
    for (int i = 0; i < 1000; ++i) {
        const LocalFrame frame(nearly_singular(i % 13, random), Symmetry::sphere);
        for (int k = 0; k < 3; ++k) {
            const double length = frame.row(k).length();
            REQUIRE(frame.length(k) >= length);
            REQUIRE(frame.length(k) <= length * (1 + 32 * unit_roundoff));
        }
    }
}

TEST_CASE("LocalFrame: given a map that is singular, or not finite, then there is none") {
    const auto exists = [](const Affine& map) {
        return LocalFrame(map, Symmetry::sphere).exists();
    };
    REQUIRE(exists({}));
    REQUIRE_FALSE(exists({{1, 2, 3}, {3, 1, 7}, {4, 3, 10}, {0, 0, 0}}));
    REQUIRE(exists({{1, 2, 3}, {3, 1, 7}, {4, 3, std::nextafter(10.0, 11.0)}, {0, 0, 0}}));
    REQUIRE_FALSE(exists({{1e-300, 0, 0}, {0, 1e300, 0}, {0, 0, 0}, {0, 0, 0}}));
    REQUIRE(exists({{1e-300, 0, 0}, {0, 1e-300, 0}, {0, 0, 1e-300}, {0, 0, 0}}));
    REQUIRE_FALSE(exists({{1, 0, 0}, {0, infinity, 0}, {0, 0, 1}, {0, 0, 0}}));
    REQUIRE_FALSE(exists({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, nan_value, 0}}));
}
