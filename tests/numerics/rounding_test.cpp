#include "core/numerics/rounding.h"

#include <cstring>

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr float float_infinity = std::numeric_limits<float>::infinity();

/// Returns doubles of all kinds for which rounding to float is difficult.
std::vector<double> awkward_doubles() {
    std::vector<double> values = {0.0,        1.0,     0x1p-149,       0x1p-150,
                                  0x1.8p-150, 1e-300,  0x1p-1074,      1e300,
                                  infinity,   1 / 3.0, 0x1.ffffffp127, 0x1.fffffep127};
    Random random(7);
    for (int i = 0; i < 100000; ++i) {
        const double mantissa = 1 + std::ldexp(static_cast<double>(random.bits() >> 12), -52);
        const int exponent = static_cast<int>(random.index(300)) - 160;
        values.push_back(std::ldexp(mantissa, exponent));
        values.push_back(static_cast<double>(static_cast<float>(values.back())));  // exact
    }
    const std::size_t count = values.size();
    for (std::size_t i = 0; i < count; ++i) values.push_back(-values[i]);
    return values;
}

struct ThreeFloats {
    float x, y, z;
};

/// The pattern that g++ 12's SLP vectoriser breaks: a pair of doubles rounded to float and widened
/// again loses the rounding.
[[gnu::noinline]] Vec3 through_floats(const Vec3& a) {
    const ThreeFloats v{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
    return {v.x, v.y, v.z};
}

}  // namespace

TEST_CASE("float_down and float_up: given any double, then the tightest floats around it") {
    for (const double x : awkward_doubles()) {
        const float below = float_down(x), above = float_up(x);
        REQUIRE(below <= x);
        REQUIRE(above >= x);
        if (below != float_infinity) REQUIRE(std::nextafter(below, float_infinity) > x);
        if (above != -float_infinity) REQUIRE(std::nextafter(above, -float_infinity) < x);
    }
    REQUIRE(std::isnan(float_down(nan_value)));
    REQUIRE(std::isnan(float_up(nan_value)));
}

TEST_CASE("round_outward: given a double box, then the float box holds it") {
    const Box3 box(Vec3(-1 / 3.0, 0.1, -1e40), Vec3(1 / 3.0, 0.1, 1e-50));
    const Box3f outer = round_outward(box);
    for (int k = 0; k < 3; ++k) {
        REQUIRE(outer.min[k] <= box.min[k]);
        REQUIRE(outer.max[k] >= box.max[k]);
    }
}

TEST_CASE("power_of_two_reciprocal: given a number, then it is brought to [1, 2)") {
    for (const double x : awkward_doubles()) {
        if (!(x > 0) || x == infinity) continue;
        const double scale = power_of_two_reciprocal(x);
        REQUIRE(std::isfinite(scale));
        int exponent;
        REQUIRE(std::frexp(scale, &exponent) == 0.5);
        const bool reachable = x >= std::numeric_limits<double>::min() / 2;
        if (reachable) REQUIRE((x * scale >= 1 && x * scale < 2));
        REQUIRE(x * scale < 2);
    }
    for (const double x : {0.0, -1.0, infinity, nan_value}) {
        REQUIRE(power_of_two_reciprocal(x) == 1);
    }
}

TEST_CASE("The compiler: given doubles rounded to float in threes, then every one is rounded") {
    Random random(11);
    for (int i = 0; i < 1000; ++i) {
        Vec3 a;
        for (int k = 0; k < 3; ++k)
            a[k] = 1 + std::ldexp(static_cast<double>(random.bits() >> 12), -52);
        const Vec3 rounded = through_floats(a);
        for (int k = 0; k < 3; ++k) {
            volatile float stored = static_cast<float>(a[k]);  // not to be kept in a register
            REQUIRE(rounded[k] == static_cast<double>(stored));
        }
    }
}

TEST_CASE("next_towards: given any finite double, then it finds what std::nextafter finds") {
    Random random(8);
    const double largest = std::numeric_limits<double>::max();
    for (const double x : {0.0, -0.0, 1.0, -1.0, 0x1p-1074, -0x1p-1074, largest, -largest}) {
        for (const double to : {3.0, -3.0}) {
            CHECK(next_towards(x, to) == std::nextafter(x, std::copysign(infinity, to)));
        }
    }
    for (int i = 0; i < 1000; ++i) {
        const double x = random.magnitude(-300, 300) * (random.one_in(2) ? 1 : -1);
        const double to = random.uniform(-1, 1);
        REQUIRE(next_towards(x, to) == std::nextafter(x, std::copysign(infinity, to)));
    }
    CHECK(next_towards(infinity, -1) == infinity);
}
