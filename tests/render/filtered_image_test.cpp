// Images whose filter is wider than a pixel, and other settings of the film.
#include "core/image/metrics/metrics.h"
#include "core/numerics/luminance.h"
#include "core/parallel/parallel.h"
#include "core/render/image_film.h"
#include "core/render/image_pixels.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"
#include "tests/sanitized.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const PixelFilter gaussian{FilterKind::gaussian, {2, 2}};

TestScene scene_with(const PixelFilter& filter, int samples) {
    TestScene scene = mixed_scene(96, 72);
    scene.settings.filter = filter;
    scene.settings.samples_per_pixel = samples;
    return scene;
}

TestScene up_to_error(const PixelFilter& filter, double error, std::uint32_t seed = 0) {
    TestScene scene = scene_with(filter, 1 << 14);
    scene.settings.target_error = error;
    scene.settings.seed = seed;
    return scene;
}

double mean_of(const std::vector<Color>& pixels) {
    const Vec3 sum = mean(pixels);
    return (sum.x + sum.y + sum.z) / 3;
}

}  // namespace

TEST_CASE("A filtered image has the same bits on any number of threads", "[film]") {
    for (const double error : {0.0, 1e-2}) {
        TestScene scene = scene_with(gaussian, 6);
        scene.settings.target_error = error;
        const std::vector<Color> reference = image(scene, reference_backend);
        for (const int threads : {1, 2, 7}) {
            const ThreadLimit limit(threads);
            CHECK(image(scene) == reference);
        }
    }
}

TEST_CASE("A crop of a filtered image is a part of it", "[film]") {
    TestScene scene = scene_with(gaussian, 3);
    const std::vector<Color> whole = image(scene);
    scene.settings.crop = {{20, 7}, {51, 40}};
    CHECK(image(scene) == cut_out(whole, 96, scene.settings.crop));
}

TEST_CASE("A filter blurs an image but keeps its mean", "[film]") {
    const std::vector<Color> sharp = image(scene_with({}, 64));
    for (const FilterType& type : filter_list) {
        if (type.kind == FilterKind::box) continue;
        CAPTURE(type.name);
        const std::vector<Color> soft = image(scene_with({type.kind, Vec2(type.radius)}, 64));
        CHECK(soft != sharp);
        CHECK(mean_of(soft) == Approx(mean_of(sharp)).epsilon(0.01));
    }
}

TEST_CASE("Samples beyond the image are not counted to its samples per pixel", "[film]") {
    const Rendering r = rendered(scene_with(gaussian, 3));
    CHECK(r.samples == 3);
    CHECK(r.film.size() == 96 * 72);
    CHECK(r.film.total_count() == 96 * 72 * 3);
    CHECK(r.counts.camera == 100 * 76 * 3);
}

TEST_CASE("The variance of a filtered image is that of each pixel's own samples", "[film]") {
    TestScene sharp = scene_with({}, 8), soft = scene_with(gaussian, 8);
    sharp.settings.variance = soft.settings.variance = true;
    CHECK(rendered(soft).film.variances() == rendered(sharp).film.variances());
}

TEST_CASE("A filtered image ends near the target error", "[film]" ETALON_LONG_IF_SANITIZED) {
    for (const double aperture : {0.0, 12.0}) {  // beneath a filter, a lens' samples lie less well
        for (const PixelFilter& filter : {gaussian, PixelFilter{FilterKind::box, {1, 1}}}) {
            TestScene reference = scene_with(filter, 1024);
            reference.camera.aperture = aperture;
            const std::vector<Color> truth =
                image_pixels(rendered(reference).film, reference.settings);
            TestScene scene = up_to_error(filter, 3e-4, 5);
            scene.camera.aperture = aperture;
            const Rendering r = rendered(scene);
            const double real = relmse(image_pixels(r.film, scene.settings), truth);
            CAPTURE(static_cast<int>(filter.kind), aperture, *r.expected_error, real, r.samples);
            CHECK(r.complete);
            CHECK(*r.expected_error <= 1.03 * 3e-4);
            CHECK(real < 1.6 * 3e-4);
            CHECK(real > 0.7 * 3e-4);
        }
    }
}

TEST_CASE("An adaptive filtered image has the same mean as a uniform one", "[film]") {
    double adaptive = 0;
    constexpr int seeds = 8;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        adaptive += mean_of(image(up_to_error(gaussian, 2e-3, seed))) / seeds;
    }
    CHECK(adaptive == Approx(mean_of(image(scene_with(gaussian, 512)))).epsilon(4e-4));
}

TEST_CASE("Bright samples are darkened to the largest luminance, and all are scaled after that",
          "[film]") {
    RenderSettings settings;
    settings.resolution = {1, 1};
    settings.max_sample_luminance = 0.5;
    settings.film_scale = 3;
    ImageFilm film({{0, 0}, {0, 0}}, settings);
    const Color dim(0.1F, 0.2F, 0.3F), bright(1, 2, 3);
    const std::array pixel{PixelRun{{0, 0}, 0, 1}};
    const std::array place{Vec2(0.5, 0.5)};
    const auto add = [&](Color color) { return film.add(pixel, place, {&color, 1}); };
    CHECK(add(dim) == 0);
    CHECK(film.samples().pixels()[0] == dim * 3);
    CHECK(add(bright) == 0);
    const Color expected = (dim + bright * (0.5F / luminance(bright))) * 1.5F;
    const Color mean = film.samples().pixels()[0];
    for (int k = 0; k < 3; ++k) CHECK(mean[k] == Approx(expected[k]));
    CHECK(add(Color(std::numeric_limits<float>::quiet_NaN())) == 1);
    CHECK(film.samples().pixels()[0].x == Approx(mean.x * 2 / 3));  // the third is black
}
