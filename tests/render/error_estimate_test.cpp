#include "core/render/error_estimate.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/sampling/sample_source.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr int side = 64;

/// A function sampled at points of the unit square, and its exact mean, for each pixel.
struct Integrand {
    double (*at)(const Vec2& point, double place);
    double (*mean)(double place);  ///< `place`: position of the pixel, in [0, 1)
};

/// The estimated error after so many samples per pixel, and the true one.
struct Errors {
    double expected, real;
};

double place_of(int pixel) {
    return pixel % 61 / 61.0;
}

/// `decodes`: the function's values are display values, and errors are those of their light.
Errors errors_after(std::uint32_t samples, const Integrand& f, Sampler sampler,
                    bool decodes = false) {
    Film film({{0, 0}, {side - 1, side - 1}});
    ErrorEstimate estimate(side, side, decodes);
    for (std::uint32_t first = 0, last = 1; first < samples;
         first = last, last = std::min(2 * last, samples)) {
        for (int i = 0; i < side * side; ++i) {
            const int x = i % side, y = i / side;
            for (std::uint32_t s = first; s < last; ++s) {
                const Vec2 point = SampleSource({x, y, 1, sampler}, s).point(0);
                film.add(x, y, Color(static_cast<float>(f.at(point, place_of(i)))));
            }
        }
        estimate.look(film);
    }
    double sum = 0;
    for (int i = 0; i < side * side; ++i) {
        const auto shown = [&](double value) { return decodes ? srgb_decoded(value) : value; };
        const double integral = shown(f.mean(place_of(i)));
        const double error = shown(film.mean(i).x) - integral;
        sum += error * error / (integral * integral + 0.01);
    }
    return {estimate.total(), sum / static_cast<double>(film.size())};
}

/// 2 on one side of a slanted line, 1 on the other.
const Integrand edge = {
    [](const Vec2& p, double place) { return p.x + 0.7 * p.y < 0.7 + 0.3 * place ? 2.0 : 1.0; },
    [](double place) { return 1.35 + 0.3 * place; },
};

const Integrand smooth = {
    [](const Vec2& p, double place) { return 1 + p.x * p.y + place; },
    [](double place) { return 1.25 + place; },
};

}  // namespace

TEST_CASE("Nothing is expected of a film before its samples were doubled", "[estimate]") {
    Film film({{0, 0}, {0, 0}});
    ErrorEstimate estimate(1, 1, false);
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
    for (const std::uint32_t samples : {8, 32, 48, 127}) {
        const Errors e = errors_after(samples, edge, Sampler::random);
        CAPTURE(samples, e.expected, e.real);
        CHECK(e.expected == Approx(e.real).epsilon(0.1));
    }
}

TEST_CASE("Of display values the error is that of the light they stand for", "[estimate]") {
    for (const std::uint32_t samples : {32, 128}) {
        const Errors e = errors_after(samples, edge, Sampler::random, true);
        CAPTURE(samples, e.expected, e.real);
        CHECK(e.expected == Approx(e.real).epsilon(0.1));
        CHECK(e.expected > 2 * errors_after(samples, edge, Sampler::random).expected);
    }
}

// The error of two-dimensional nets falls alternately faster and slower, as their cells are squares
// or not.
TEST_CASE("Of well distributed samples of edges the error is known to a factor of 1.7",
          "[estimate]") {
    for (const std::uint32_t samples : {16, 32, 64, 128}) {
        const Errors e = errors_after(samples, edge, Sampler::sobol);
        CAPTURE(samples, e.expected, e.real);
        CHECK(e.expected < e.real * 1.7);
        CHECK(e.expected > e.real / 1.7);
    }
}

TEST_CASE("Of a smooth surface no less error is expected than there is", "[estimate]") {
    const Errors e = errors_after(16, smooth, Sampler::sobol);
    CAPTURE(e.expected, e.real);
    CHECK(e.real < 1e-3);
    CHECK(e.expected > e.real);
}

TEST_CASE("A pixel's own change does not enter the estimate from its neighbours", "[estimate]") {
    Film film({{0, 0}, {2, 2}});
    ErrorEstimate estimate(3, 3, false);
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

TEST_CASE("The estimate of an image is the mean of those of its blocks of 32 x 32 pixels",
          "[estimate]") {
    const Imath::V2i blocks(2, 3);
    Film whole({{0, 0}, {32 * blocks.x - 1, 32 * blocks.y - 1}});
    ErrorEstimate estimate(32 * blocks.x, 32 * blocks.y, false);
    std::vector<Film> parts(6, Film({{0, 0}, {31, 31}}));
    std::vector<ErrorEstimate> estimates(6, ErrorEstimate(32, 32, false));
    for (std::uint32_t first = 0, last = 1; last <= 16; first = last, last *= 2) {
        for (std::uint32_t s = first; s < last; ++s) {
            for (int i = 0; i < 32 * 32 * 6; ++i) {
                const int x = i % 64, y = i / 64, block = x / 32 + y / 32 * 2;
                const Vec2 point = SampleSource({x, y, 1, Sampler::sobol}, s).point(0);
                const double value =
                    block % 2 == 0 ? edge.at(point, block / 6.0) : smooth.at(point, block / 6.0);
                const Color color(static_cast<float>(value));
                whole.add(x, y, color);
                parts[block].add(x % 32, y % 32, color);
            }
        }
        estimate.look(whole);
        for (int block = 0; block < 6; ++block) estimates[block].look(parts[block]);
    }
    double sum = 0;
    for (int block = 0; block < 6; ++block) {
        CHECK(estimate.rate(block % 2 * 32 + 5, block / 2 * 32 + 31) ==
              estimates[block].rate(0, 0));
        sum += estimates[block].total() / 6;
    }
    CHECK(estimate.total() == Approx(sum));
}

TEST_CASE("A change of a filtered image is shared by the pixels that were doubled", "[estimate]") {
    Film film({{0, 0}, {1, 0}});
    ErrorEstimate estimate(2, 1, false);
    FilteredErrors errors{{Vec3(1), Vec3(1)}, 0};
    const auto add = [&](int x, float value) { film.add(x, 0, Color(value)); };
    const auto look = [&](double change) {
        errors.change = change;
        estimate.look(film, &errors);
        return estimate.total() * (std::exp2(estimate.rate(0, 0)) - 1);
    };
    for (const int x : {0, 1}) add(x, 1);
    look(0);
    add(0, 2), add(1, 4);  // squared changes of 1/4 and 9/4
    CHECK(look(0.5) == Approx(0.5));
    for (int i = 0; i < 2; ++i) add(0, 3);
    CHECK(look(0.25) == Approx(0.25 + 0.9 * 0.5));  // only the first was doubled
}
