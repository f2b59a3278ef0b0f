#include "core/image/metrics/flip.h"

#include "tests/catch.h"
#include "tests/image/formula_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

double flip_of(Pixels a, Pixels b, int width) {
    return flip(flip_map(a, b, width));
}

}  // namespace

TEST_CASE("FLIP agrees with NVIDIA's program") {
    // Its header FLIP.h, version 1.6, LDR with PPD = 67, the mean summed in double. It works in
    // float: the last digits are its rounding.
    const std::vector<Color> reference = stripes(96, 64);
    CHECK(flip_of(rings(96, 64), reference, 96) == Approx(0.8435574092).epsilon(1e-6));
    CHECK(flip_of(bright(96, 64), reference, 96) == Approx(0.6324863857).epsilon(1e-6));
    CHECK(flip_of(faded(96, 64), reference, 96) == Approx(0.2057538113).epsilon(1e-6));
    SECTION("where the filters are wider than the picture") {
        CHECK(flip_of(rings(7, 5), stripes(7, 5), 7) == Approx(0.894449532).epsilon(1e-6));
        CHECK(flip_of(rings(200, 8), stripes(200, 8), 200) == Approx(0.8039393084).epsilon(1e-6));
        CHECK(flip_of(rings(1, 40), stripes(1, 40), 1) == Approx(0.9742380068).epsilon(1e-6));
    }
}

TEST_CASE("a pixel that differs is seen where the filters reach, and nowhere else") {
    const std::vector<Color> a = stripes(61, 61);
    std::vector<Color> b = a;
    b[30 * 61 + 30] = Color(1, 1, 1);
    const PixelPlane map = flip_map(a, b, 61);
    for (int y = 0; y < 61; ++y) {
        for (int x = 0; x < 61; ++x) {
            INFO(x << " " << y);
            const int distance = std::max(std::abs(x - 30), std::abs(y - 30));
            if (distance > 10) CHECK(map.row(y)[x] == 0);
            if (distance < 3) CHECK(map.row(y)[x] > 0.01);
        }
    }
}

TEST_CASE("FLIP is 0 for equal images, symmetric, and 1 between blue and green") {
    const std::vector<Color> a = stripes(50, 30), b = rings(50, 30);
    CHECK(flip_of(a, a, 50) == 0);
    CHECK(flip_of(a, b, 50) == flip_of(b, a, 50));
    const std::vector<Color> blue(600, Color(0, 0, 1)), green(600, Color(0, 1, 0));
    CHECK(flip_of(blue, green, 30) == Approx(1).epsilon(1e-12));
}

TEST_CASE("FLIP uses what a display shows: NaN as black, infinities as black and white") {
    constexpr float inf = std::numeric_limits<float>::infinity();
    const std::vector<Color> wild(100, Color(std::numeric_limits<float>::quiet_NaN(), -inf, inf)),
        shown(100, Color(0, 0, 1)), other = stripes(10, 10);
    CHECK(flip_of(wild, shown, 10) == 0);
    CHECK(flip_of(wild, other, 10) == flip_of(shown, other, 10));
}

TEST_CASE("the map of FLIP has the same bits on one thread and on several", "[needs_two_cores]") {
    SKIP_UNLESS(max_threads() >= 2, "a single core");
    const std::vector<Color> a = stripes(311, 173), b = rings(311, 173);
    const PixelPlane several = flip_map(a, b, 311);
    const ThreadLimit one(1);
    CHECK(flip_map(a, b, 311).values == several.values);
}
