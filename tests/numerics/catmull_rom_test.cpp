#include "core/numerics/catmull_rom.h"

#include <vector>

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

const std::vector<float> nodes = {0, 0.5F, 1.5F, 2, 4, 4.5F};

/// Values of a cubic at the nodes of an even spline.
double value_at(const std::vector<float>& x, const std::vector<float>& f, float at) {
    const auto weights = spline_weights(x, at);
    REQUIRE(weights);
    return weights->sum([&](std::size_t k) { return f[k]; });
}

}  // namespace

TEST_CASE("A spline goes through its values and is straight where they are", "[spline]") {
    const std::vector<float> line = {1, 2, 4, 5, 9, 10}, other = {1, 0, 3, 2, 5, 1};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        CHECK(value_at(nodes, other, nodes[k]) == Approx(other[k]).margin(1e-6));
    }
    for (const float x : {0.1F, 0.9F, 1.7F, 3.3F, 4.4F}) {
        CHECK(value_at(nodes, line, x) == Approx(1 + 2 * x));
    }
    CHECK_FALSE(spline_weights(nodes, -0.1F));
    CHECK_FALSE(spline_weights(nodes, 4.6F));
    CHECK_FALSE(spline_weights(nodes, std::numeric_limits<float>::quiet_NaN()));
}

TEST_CASE("A spline's segments are what its weights say", "[spline]") {
    const std::vector<float> f = {1, 0.5F, 3, 2, 5, 1};
    const auto value = [&](std::size_t k) -> double { return f[k]; };
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const SplineSegment s = spline_segment(nodes, value, i);
        double integral = 0;
        constexpr int steps = 1000;
        for (int k = 0; k < steps; ++k) {
            const double t = (k + 0.5) / steps;
            integral += s.value(t) / steps;
            CHECK(s.value(t) ==
                  Approx(value_at(nodes, f, static_cast<float>(s.begin + t * s.width)))
                      .epsilon(1e-4));
            const double h = 1e-6;
            CHECK(s.derivative(t) ==
                  Approx((s.value(t + h) - s.value(t - h)) / (2 * h)).margin(1e-5));
        }
        CHECK(s.integral(1) == Approx(integral).epsilon(1e-4));
    }
}

TEST_CASE("Places are chosen in proportion to a spline", "[spline]") {
    const std::vector<float> f = {0, 0.5F, 3, 2, 5, 1};
    std::vector<float> sums(f.size());
    const double whole = integrate_spline(nodes, f, sums);
    const auto value = [&](std::size_t k) -> double { return f[k]; };
    const auto sum = [&](std::size_t k) -> double { return sums[k]; };
    for (int k = 0; k < 1000; ++k) {
        const double u = (k + 0.5) / 1000;
        const SplineSample chosen = sample_spline(nodes, value, sum, u);
        // The integral up to it is the fraction u.
        const std::size_t i =
            spline_interval(nodes.size(), [&](std::size_t n) { return nodes[n] <= chosen.x; });
        const SplineSegment s = spline_segment(nodes, value, i);
        const double below = sums[i] + s.width * s.integral((chosen.x - s.begin) / s.width);
        CHECK(below == Approx(u * whole).epsilon(1e-5));
        CHECK(chosen.value ==
              Approx(value_at(nodes, f, static_cast<float>(chosen.x))).epsilon(1e-4));
    }
}

TEST_CASE("A rising spline is inverted", "[spline]") {
    const std::vector<float> f = {0, 1, 2, 4, 5, 9};
    for (const float x : {0.0F, 0.3F, 1.2F, 1.9F, 3.9F, 4.5F}) {
        const auto y = static_cast<float>(value_at(nodes, f, x));
        CHECK(invert_spline(nodes, f, y) == Approx(x).margin(1e-5));
    }
    CHECK(invert_spline(nodes, f, -3) == 0);
    CHECK(invert_spline(nodes, f, 30) == 4.5F);
}
