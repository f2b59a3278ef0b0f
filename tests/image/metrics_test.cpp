#include "core/image/metrics/metrics.h"

#include <cmath>

#include "core/parallel/parallel.h"
#include "tests/catch.h"
#include "tests/image/formula_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

using List = std::vector<Color>;

}  // namespace

TEST_CASE("metrics of two pixels are those worked out by hand") {
    const List a = {{1, 0.5F, 0}, {0.25F, 2, 3}}, b = {{0.5F, 0.5F, 0.25F}, {0.25F, 0, 3}};
    CHECK(mse(a, b) == (0.25 + 0.0625 + 4) / 6);
    CHECK(mae(a, b) == (0.5 + 0.25 + 2) / 6);
    CHECK(max_abs(a, b) == 2);
    CHECK(different_pixels(a, b) == 2);
    CHECK(relmse(a, b) == Approx((0.25 / 0.26 + 0.0625 / 0.0725 + 4 / 0.01) / 6).epsilon(1e-14));
    CHECK(relmse(b, a) == Approx((0.25 / 1.01 + 0.0625 / 0.01 + 4 / 4.01) / 6).epsilon(1e-14));
    CHECK(mean(a) == Vec3(0.625, 1.25, 1.5));
    CHECK(mean(b) == Vec3(0.375, 0.25, 1.625));
    CHECK(psnr(0.01) == Approx(20).epsilon(1e-14));
    CHECK_FALSE(std::signbit(psnr(1)));  // written as 0, not as -0
}

TEST_CASE("equal images do not differ, whatever their values") {
    const List a = {{0, inf, -inf}, {not_a_number, 1, -0.0F}},
               b = {{-0.0F, inf, -inf}, {-not_a_number, 1, 0}};
    CHECK(mse(a, b) == 0);
    CHECK(relmse(a, b) == 0);
    CHECK(mae(a, b) == 0);
    CHECK(max_abs(a, b) == 0);
    CHECK(different_pixels(a, b) == 0);
    CHECK(psnr(0) == infinity);
}

TEST_CASE("a value that is not finite in one image only is an infinite error in one pixel") {
    const auto [x, y] =
        GENERATE(std::pair(not_a_number, 1.0F), std::pair(1.0F, not_a_number), std::pair(inf, -inf),
                 std::pair(inf, 0.0F), std::pair(0.0F, -inf), std::pair(inf, not_a_number));
    INFO(x << " " << y);
    const List a = {{0, x, 0}, {1, 1, 1}}, b = {{0, y, 0}, {1, 1, 1}};
    CHECK(mse(a, b) == infinity);
    CHECK(relmse(a, b) == infinity);
    CHECK(mae(a, b) == infinity);
    CHECK(max_abs(a, b) == infinity);
    CHECK(different_pixels(a, b) == 1);
    CHECK(psnr(infinity) == -infinity);
}

TEST_CASE("the largest floats have a finite error") {
    constexpr float most = std::numeric_limits<float>::max();
    const List a = {{most, most, most}}, b = {{-most, -most, -most}};
    CHECK(max_abs(a, b) == 2.0 * most);
    CHECK(mse(a, b) == 4.0 * most * most);
}

TEST_CASE("metrics have the same bits on one thread and on several", "[needs_two_cores]") {
    SKIP_UNLESS(max_threads() >= 2, "a single core");
    const List a = stripes(311, 173), b = rings(311, 173);
    const auto all = [&] {
        const Vec3 m = mean(a);
        return std::vector<double>{mse(a, b), relmse(a, b), mae(a, b), m.x, m.y, m.z};
    };
    const std::vector<double> several = all();
    const ThreadLimit one(1);
    CHECK(all() == several);
}
