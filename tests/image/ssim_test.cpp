#include "core/image/metrics/ssim.h"

#include "core/parallel/parallel.h"
#include "tests/catch.h"
#include "tests/image/formula_images.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("SSIM agrees with scikit-image") {
    // Version 0.19.3, of the images encoded as sRGB: structural_similarity(a, b, channel_axis=2,
    // data_range=1, gaussian_weights=True, sigma=1.5, use_sample_covariance=False).
    const std::vector<Color> reference = stripes(96, 64);
    CHECK(ssim(rings(96, 64), reference, 96) == Approx(0.5170240113700966).epsilon(1e-9));
    CHECK(ssim(faded(96, 64), reference, 96) == Approx(0.9915728207436687).epsilon(1e-9));
    CHECK(ssim(bright(96, 64), reference, 96) == Approx(0.6958866329673961).epsilon(1e-9));
    CHECK(ssim(rings(311, 173), stripes(311, 173), 311) ==
          Approx(0.2299591099672311).epsilon(1e-9));
}

TEST_CASE("SSIM is 1 for equal images of any size, and less for others") {
    const auto [width, height] = GENERATE(std::pair(1, 1), std::pair(1, 30), std::pair(10, 10),
                                          std::pair(11, 11), std::pair(40, 5), std::pair(12, 30));
    INFO(width << " " << height);
    const std::vector<Color> a = stripes(width, height), b = faded(width, height);
    CHECK(ssim(a, a, width) == 1);
    CHECK(ssim(a, b, width) < 1);
    CHECK(ssim(a, b, width) > 0);
}

TEST_CASE("SSIM of two constant images compares their means alone") {
    // Equation 6 of the paper, for the encoded values 0.5 and 0.25 of these linear ones.
    const std::vector<Color> a(400, Color(0.21404114F)), b(400, Color(0.05087609F));
    CHECK(ssim(a, b, 20) == Approx((2 * 0.5 * 0.25 + 1e-4) / (0.25 + 0.0625 + 1e-4)).epsilon(1e-6));
}

TEST_CASE("SSIM has the same bits on one thread and on several", "[needs_two_cores]") {
    SKIP_UNLESS(max_threads() >= 2, "a single core");
    const std::vector<Color> a = stripes(311, 173), b = rings(311, 173);
    const double several = ssim(a, b, 311);
    const ThreadLimit one(1);
    CHECK(ssim(a, b, 311) == several);
}
