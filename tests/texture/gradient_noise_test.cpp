#include "core/texture/gradient_noise.h"

#include <cmath>
#include <limits>
#include <vector>

#include "core/numerics/random.h"
#include "core/texture/fractal_noise.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns points all over the lattice, on its points, far beyond it, and no points at all.
std::vector<Vec3> some_points() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    std::vector<Vec3> points{{0, 0, 0},       {-0.0, 3, -7},    {255, 256, 257},
                             {0.5, 0.5, 0.5}, {1e17, -1e17, 1}, {1e300, 0.25, 0.5},
                             {inf, 0, 0},     {0, -inf, 0},     {0, 0, std::nan("")}};
    Random random(4);
    for (int i = 0; i < 3000; ++i) {
        const double scale = std::exp2(random.uniform(-12, 20));
        points.push_back(scale * random.direction());
        const Vec3 p = points.back();
        points.emplace_back(std::round(p.x), p.y, std::nextafter(std::round(p.z), -inf));
    }
    return points;
}

Vec3Buffer columns_of(const std::vector<Vec3>& points) {
    Vec3Buffer columns;
    columns.make_room(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) columns.set(i, points[i]);
    return columns;
}

}  // namespace

TEST_CASE("Noise: points together have the values of points alone, by any instructions",
          "[texture]") {
    const std::vector<Vec3> points = some_points();
    const Vec3Buffer columns = columns_of(points);
    std::vector<double> expected;
    for (const Vec3& p : points) expected.push_back(gradient_noise(p));
    for_each_target([&] {
        for (const std::size_t count : {std::size_t{1}, std::size_t{7}, points.size()}) {
            std::vector<double> values(count + padded_doubles);
            gradient_noise(columns.span(), count, values.data());
            for (std::size_t i = 0; i < count; ++i) {
                CAPTURE(i, points[i]);
                if (values[i] != expected[i]) CHECK(values[i] == expected[i]);
            }
        }
    });
}

TEST_CASE("Noise: smooth, within its range, 0 on the lattice and where there is no point",
          "[texture]") {
    for (const Vec3& p : some_points()) {
        CAPTURE(p);
        const double value = gradient_noise(p);
        if (!is_finite(p) ||
            (p.x == std::floor(p.x) && p.y == std::floor(p.y) && p.z == std::floor(p.z))) {
            CHECK(value == 0);
            continue;
        }
        CHECK(std::abs(value) <= 1);
        if (max_abs(p) > 1e3) continue;
        CHECK(std::abs(gradient_noise(p + Vec3(1e-7)) - value) < 1e-6);
        CHECK(std::abs(gradient_noise(p + Vec3(256, -512, 256)) - value) < 1e-9);
    }
}

TEST_CASE("Fractal noise: the weighted sum of octaves at any number of them", "[texture]") {
    const Vec3 p(0.3, -1.7, 2.9);
    for (const int octaves : {-1, 0, 1, 5, 8, 13, 54, 1000}) {
        double sum = 0, magnitudes = 0, weight = 1, frequency = 1;
        for (int i = 0; i < octaves && frequency < 1e16; ++i) {
            const double value = gradient_noise(frequency * p);
            sum += weight * value;
            magnitudes += weight * std::abs(value);
            weight *= 0.75F;
            frequency *= lacunarity;
        }
        CAPTURE(octaves);
        CHECK(fractional_brownian_motion({octaves, 0.75F}, p) == sum);
        CHECK(turbulence({octaves, 0.75F}, p) ==
              magnitudes + 0.2 * std::pow(0.75, std::max(octaves, 0)));
    }
}
