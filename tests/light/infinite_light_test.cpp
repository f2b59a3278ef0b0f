#include "core/light/infinite_light.h"

#include <limits>
#include <numbers>

#include "core/image/io.h"
#include "core/sampling/sobol.h"
#include "tests/catch.h"
#include "tests/chi_square.h"
#include "tests/light/uniform_direction.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

/// A light with an image of 16 x 8 texels, of which only one is bright.
InfiniteSource one_bright_texel(const test::TemporaryFolder& folder) {
    RenderedImage image{16, 8, {{0, 0}, {15, 7}}, std::vector(16 * 8, Color(0.1F)), false, {}};
    image.pixels[3 * 16 + 5] = Color(50, 100, 200);
    const std::string file = folder / "sky.exr";
    REQUIRE(write_image(file, image).empty());
    // x, y and z of the light are y, z and x of the world.
    return {Color(2, 1, 0.5F), file, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
}

}  // namespace

TEST_CASE("A light of one colour is left to the directions that surfaces choose", "[light]") {
    std::vector<std::string> problems;
    const InfiniteLight light({Color(1, 2, 3)}, problems);
    CHECK(light.radiance({0, 0, 1}) == Color(1, 2, 3));
    CHECK_FALSE(light.can_be_sampled());
    CHECK(light.sample({0.5, 0.5}).pdf == 0);
    CHECK(light.pdf({0, 1, 0}) == 0);
}

TEST_CASE("A map has sides of powers of two, as pbrt-v3 makes it of any other", "[light]") {
    const test::TemporaryFolder folder;
    RenderedImage image{5, 3, {{0, 0}, {4, 2}}, std::vector(5 * 3, Color(0.25F, 1, 3)), false, {}};
    REQUIRE(write_image(folder / "sky.exr", image).empty());
    std::vector<std::string> problems;
    const SphericalImage map(folder / "sky.exr", problems);
    REQUIRE(problems.empty());
    CHECK(map.width() == 8);
    CHECK(map.height() == 4);
    CHECK(std::abs(map.texel(6, 1).z - 3) < 1e-5);
    image.pixels[7] = Color(100.0F);
    REQUIRE(write_image(folder / "sky.exr", image).empty());
    const SphericalImage bright(folder / "sky.exr", problems);
    CHECK(std::abs(bright.texel(4, 2).x - 58.49738) < 1e-3);  // by the formulas of the filter
    CHECK(bright.texel(0, 0).x >= 0);
}

TEST_CASE("A map goes on from its other side beyond every border, as in pbrt-v3", "[light]") {
    const SphericalImage map(2, 2, {Color(1), Color(2), Color(4), Color(8)});
    CHECK(map.at({0.25, 0}) == Color(2.5F));
    CHECK(map.at({0.75, 1}) == Color(5));
    CHECK(map.at({0, 0.25}) == Color(1.5F));
    CHECK(map.at({1, 0.75}) == Color(6));
    CHECK(map.at({0, 0}) == Color(3.75F));
}

TEST_CASE("Directions are sampled as often as their density says", "[light]") {
    const test::TemporaryFolder folder;
    std::vector<std::string> problems;
    const InfiniteLight light(one_bright_texel(folder), problems);
    REQUIRE(problems.empty());
    REQUIRE(light.can_be_sampled());
    const ScrambledSobol points(5);
    constexpr std::uint32_t count = 1 << 16;
    double integral = 0, mean_from_samples = 0, mean = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 d = test::uniform_direction(points(i));
        integral += 4 * pi * light.pdf(d) / count;
        // The part that samples leave out, and the whole.
        if (light.pdf(d) > 0) mean += light.radiance(d).y / count;
        const LightSample s = light.sample(points(i));
        REQUIRE(s.pdf > 0);
        CHECK(s.at_infinity);
        CHECK_THAT(light.pdf(s.wi), WithinRel(double{s.pdf}, 1e-4));
        CHECK_THAT(light.radiance(s.wi).y, WithinRel(s.radiance.y, 1e-3F));
        mean_from_samples += s.radiance.y / s.pdf / (4 * pi) / count;
    }
    CHECK_THAT(integral, WithinRel(1.0, 1e-2));
    CHECK_THAT(mean_from_samples, WithinRel(mean, 1e-2));
}

TEST_CASE("Directions to a sky are drawn with the density that is said of them", "[light]") {
    const test::TemporaryFolder folder;
    RenderedImage image{512, 256, {{0, 0}, {511, 255}}, {}, false, {}};
    for (int i = 0; i < 512 * 256; ++i) {
        const double x = i % 512 / 512.0, y = i / 512 / 256.0;
        image.pixels.emplace_back(
            static_cast<float>(y < 0.5 ? 2 + std::sin(6 * pi * x + 9 * y) : 0.2));
    }
    REQUIRE(write_image(folder / "sky.exr", image).empty());
    const Affine turned{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}},
        sheared{{0, 0, 3}, {1, 0.5, 0}, {0, -0.4, 0.25}, {0, 0, 0}};
    for (const auto& [to_light, sampling] :
         {std::pair(turned, SkySampling::above_mean), std::pair(turned, SkySampling::whole),
          std::pair(sheared, SkySampling::whole)}) {
        std::vector<std::string> problems;
        const InfiniteLight light({Color(1), folder / "sky.exr", to_light}, problems, sampling);
        REQUIRE(problems.empty());
        const auto sample = [&](Random& random) -> std::optional<Vec3> {
            const double u = random.uniform();
            return light.sample({u, random.uniform()}).wi;
        };
        const auto density = [&](const Vec3& wi) { return light.pdf(wi); };
        CHECK(test::chi_square_probability(sample, density, 3) > 1e-3);
        const auto wrong = [&](const Vec3& wi) { return light.pdf(wi) * (wi.y > 0 ? 1.04 : 0.96); };
        CHECK(test::chi_square_probability(sample, wrong, 3) < 1e-3);
    }
}

TEST_CASE("A sky with a texel that is no finite number is sampled where the others are bright",
          "[light]") {
    const test::TemporaryFolder folder;
    for (const float odd :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        RenderedImage image{16, 8, {{0, 0}, {15, 7}}, std::vector(16 * 8, Color(0.1F)), false, {}};
        image.pixels[3 * 16 + 5] = Color(100);
        image.pixels[4 * 16 + 12] = Color(0.1F, odd, 0.1F);
        REQUIRE(write_image(folder / "sky.exr", image).empty());
        std::vector<std::string> problems;
        const InfiniteLight light({Color(1), folder / "sky.exr"}, problems);
        REQUIRE(problems.empty());
        REQUIRE(light.can_be_sampled());
        CHECK(is_finite(light.mean()));
        CHECK(light.mean().x > 0.5F);
        const ScrambledSobol points(5);
        for (std::uint32_t i = 0; i < 256; ++i) {
            const LightSample s = light.sample(points(i));
            CHECK(s.pdf > 0);
            CHECK(is_finite(s.radiance));
        }
    }
}

TEST_CASE("An image that is missing is reported, and its light has one colour", "[light]") {
    std::vector<std::string> problems;
    const InfiniteLight light({Color(3), "no/such.exr"}, problems);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].find("no/such.exr") == 0);
    CHECK(light.radiance({1, 0, 0}) == Color(3));
}
