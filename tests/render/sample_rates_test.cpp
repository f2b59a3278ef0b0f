// More samples at the outlines of bright lights.
#include "core/render/sample_rates.h"
#include "core/image/image.h"
#include "core/image/metrics/metrics.h"
#include "core/parallel/parallel.h"
#include "tests/catch.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"
#include "tests/sanitized.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// A floor lit by a visible ball of that radiance, at 40 x 30 pixels.
TestScene lit_floor(int samples, double radiance, const std::string& filter = "gaussian") {
    TestScene scene = pbrt_scene(
        "AttributeBegin AreaLightSource \"diffuse\" \"color L\" [" + std::to_string(radiance) +
            " 100 100] Translate .2 .4 0\n"
            "Shape \"sphere\" \"float radius\" .25 AttributeEnd\n"
            "Material \"matte\" Translate 0 -1 0 Rotate 90 1 0 0\n"
            "Shape \"disk\" \"float radius\" 9\n",
        "Camera \"perspective\" \"float fov\" 40\nPixelFilter \"" + filter + "\"");
    scene.settings.resolution = {40, 30};
    scene.settings.samples_per_pixel = samples;
    return scene;
}

std::vector<Color> with_seed(TestScene scene, std::uint64_t seed) {
    scene.settings.seed = seed;
    return image(scene);
}

/// Returns the number of pixels with more samples than others.
std::ptrdiff_t preferred(const Rendering& rendering) {
    const auto& counts = rendering.film.counts();
    const std::uint32_t least = *std::ranges::min_element(counts);
    return std::ranges::count_if(counts, [&](std::uint32_t count) { return count > least; });
}

}  // namespace

TEST_CASE("Pixels at the outline of a bright light have up to 16 times the samples", "[rates]") {
    const Rendering r = rendered(lit_floor(8, 100));
    const auto [least, most] = std::ranges::minmax_element(r.film.counts());
    CHECK(*least == 8);
    CHECK(*most == 8 * 16);
    CHECK(preferred(r) > 12);
    CHECK(preferred(r) < 100);
    CHECK(r.complete);
}

TEST_CASE("Images of few samples, dim lights and lights out of view have even samples", "[rates]") {
    CHECK(preferred(rendered(lit_floor(7, 100))) == 0);
    TestScene away = lit_floor(8, 100);
    away.settings.crop = {{0, 22}, {39, 29}};
    CHECK(preferred(rendered(away)) == 0);
    const TestScene even = pbrt_scene(
        "LightSource \"infinite\" \"color L\" [1 1 1]\nMaterial \"matte\" Shape \"sphere\"");
    CHECK(preferred(rendered(even)) == 0);
}

TEST_CASE("More samples at outlines lower an image's error and keep its mean",
          "[rates]" ETALON_LONG_IF_SANITIZED) {
    for (const char* const filter : {"box", "gaussian", "mitchell"}) {
        CAPTURE(filter);
        const std::vector<Color> truth = with_seed(lit_floor(2048, 100, filter), 77);
        double error = 0, even_error = 0;
        Vec3 sum(0);
        constexpr int seeds = 16;
        for (int seed = 0; seed < seeds; ++seed) {
            const std::vector<Color> pixels = with_seed(lit_floor(8, 100, filter), seed);
            error += relmse(pixels, truth) / seeds;
            even_error += relmse(with_seed(lit_floor(7, 100, filter), seed), truth) / seeds;
            sum += mean(pixels) / seeds;
        }
        const Vec3 exact = mean(truth);
        CAPTURE(error, even_error, sum.x, exact.x);
        CHECK(sum.x == Approx(exact.x).epsilon(2e-3));
        CHECK(error < even_error / 4);
    }
}

TEST_CASE("Images with more samples at outlines have the same bits in parts and on all threads",
          "[rates]") {
    for (const char* const filter : {"box", "gaussian"}) {
        TestScene scene = lit_floor(8, 100, filter);
        const std::vector<Color> whole = image(scene, "none");
        for (const int threads : {1, 3}) {
            const ThreadLimit limit(threads);
            for (const char* const backend : {"grid", "bvh", "embree"}) {
                CHECK(image(scene, backend) == whole);
            }
        }
        scene.settings.crop = {{15, 3}, {30, 20}};
        CHECK(image(scene) == cut_out(whole, 40, scene.settings.crop));
    }
}
