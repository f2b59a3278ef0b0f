#include "core/render/error_estimate.h"

#include <cmath>
#include <functional>

#include "core/sampling/sample_source.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr int side = 64;

/// What a sample of a pixel is, of a point in the unit square.
using Integrand = std::function<double(const Vec2&)>;

/// The error expected after so many samples of each pixel, and the true one.
struct Errors {
    double expected, real;
};

Errors errors_after(std::uint32_t samples, const Integrand& f, double integral, Sampler sampler) {
    Film film({{0, 0}, {side - 1, side - 1}});
    ErrorEstimate estimate(side, side);
    for (std::uint32_t first = 0, last = 1; first < samples; first = last, last *= 2) {
        for (int i = 0; i < side * side; ++i) {
            const int x = i % side, y = i / side;
            for (std::uint32_t s = first; s < last; ++s) {
                const Vec2 point = SampleSource(x, y, 1, s, sampler).point(0);
                film.add(x, y, Color(static_cast<float>(f(point))));
            }
        }
        estimate.look(film);
    }
    double sum = 0;
    for (std::size_t i = 0; i < film.size(); ++i) {
        const double error = film.mean(i).x - integral;
        sum += error * error / (integral * integral + 0.01);
    }
    return {estimate.total(), sum / static_cast<double>(film.size())};
}

double edge(const Vec2& p) {
    return p.x + 0.7 * p.y < 0.85 ? 2 : 1;
}

/// The mean length below the edge, from x = 0.85 to 0.15, above 1.
const double edge_integral = 1 + (0.85 + 0.15) / 2;

double smooth(const Vec2& p) {
    return 1 + p.x * p.y;
}

}  // namespace

TEST_CASE("Nothing is expected of a film before its samples were doubled", "[estimate]") {
    Film film({{0, 0}, {0, 0}});
    ErrorEstimate estimate(1, 1);
    estimate.look(film);
    film.add(0, 0, Color(1.0F));
    estimate.look(film);
    CHECK_FALSE(estimate.exists());
    film.add(0, 0, Color(1.0F));
    estimate.look(film);
    CHECK(estimate.exists());
    CHECK(estimate.total() == 0);
}

TEST_CASE("Of independent samples the error is known to a tenth", "[estimate]") {
    for (const std::uint32_t samples : {8, 32}) {
        const Errors e = errors_after(samples, edge, edge_integral, Sampler::random);
        CAPTURE(samples, e.expected, e.real);
        CHECK(e.expected == Approx(e.real).epsilon(0.1));
    }
}

TEST_CASE("Of well distributed samples of an edge the error is known to a third", "[estimate]") {
    for (const std::uint32_t samples : {8, 16, 32, 64}) {
        const Errors e = errors_after(samples, edge, edge_integral, Sampler::sobol);
        CAPTURE(samples, e.expected, e.real);
        CHECK(e.expected < e.real * 4 / 3);
        CHECK(e.expected > e.real * 2 / 3);
    }
}

TEST_CASE("Of a smooth surface no less error is expected than there is", "[estimate]") {
    const Errors e = errors_after(16, smooth, 1.25, Sampler::sobol);
    CAPTURE(e.expected, e.real);
    CHECK(e.real < 1e-3);
    CHECK(e.expected > e.real);
}

TEST_CASE("What a pixel itself changed has no part in what its neighbours say", "[estimate]") {
    Film film({{0, 0}, {2, 2}});
    ErrorEstimate estimate(3, 3);
    const auto add = [&](float centre, float others) {
        for (int i = 0; i < 9; ++i) film.add(i % 3, i / 3, Color(i == 4 ? centre : others));
        estimate.look(film);
    };
    add(0, 1);
    add(1, 1);
    CHECK(estimate.by_neighbours(1, 1) == 0);
    CHECK(estimate.by_neighbours(0, 0) > 0);
    CHECK(estimate.by_neighbours(0, 1) > estimate.by_neighbours(0, 0));  // it shares a side
}
