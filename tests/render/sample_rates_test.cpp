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

/// A camera that sees a pixel of an image of this size in each unit square of the plane z = 0.
constexpr int width = 40, height = 30;

Camera flat_camera() {
    Camera camera;
    camera.projective.emplace();
    camera.projective->projection = Projection::orthographic;
    camera.projective->fixed_window = ImageWindow{0, width, -height, 0};
    return camera;
}

/// Shows a bright light at the centre of a pixel, and elsewhere an even floor that it lights.
class OneLight : public Integrator {
  public:
    explicit OneLight(float light, float floor) : light_(light), floor_(floor) {}

    bool shows_lights() const override { return true; }
    void emission(const CameraSamples& samples, std::span<Color> colors) const override {
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const Vec3 off = samples.rays[i].origin - Vec3(5.5, -8.5, 0);
            colors[i] = Color(off.length() < 0.25 ? light_ : 0.0F);
        }
    }
    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts&) const override {
        emission(samples, colors);
        for (Color& color : colors) color += Color(floor_);
        for (const SampleSource& source : samples.sources) points.push_back(source.point(77));
    }

    mutable std::vector<Vec2> points;  ///< of all samples; one thread adds to it

  private:
    float light_, floor_;
};

/// Shows a random number of each sample, and the same light.
class Numbers : public OneLight {
  public:
    Numbers() : OneLight(1e4F, 1) {}
    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts&) const override {
        for (std::size_t i = 0; i < colors.size(); ++i) {
            colors[i] = Color(static_cast<float>(samples.sources[i].point(77).x));
        }
    }
};

RenderSettings flat_settings() {
    RenderSettings settings;
    settings.resolution = {width, height};
    settings.samples_per_pixel = 8;
    return settings;
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

TEST_CASE(
    "A rate is a sixteenth of the step around a pixel's centre, by the mean of what is scattered",
    "[rates]") {
    RenderSettings settings = flat_settings();
    settings.pixel_rays = PixelRays::upper_left;  // of images without samples
    const auto rate = [&](float light, float floor, int x, int y) {
        const SampleRates rates = sample_rates(flat_camera(), OneLight(light, floor), settings,
                                               {{0, 0}, {width - 1, height - 1}});
        return rates.empty() ? 0 : rates[static_cast<std::size_t>(y) * width + x];
    };
    for (int y = 6; y <= 10; ++y) {
        for (int x = 3; x <= 7; ++x) {
            const bool is_near = std::abs(x - 5) <= 1 && std::abs(y - 8) <= 1;
            CAPTURE(x, y);
            CHECK(rate(64, 1, x, y) == (is_near ? 4 : 1));
        }
    }
    CHECK(rate(1e6F, 1, 5, 8) == 16);
    CHECK(rate(260, 4, 5, 8) == 4);
    CHECK(rate(250, 4, 5, 8) == 2);
    CHECK(rate(31, 1, 5, 8) == 0);
}

TEST_CASE("Rates depend on other samples than those of the image", "[rates]") {
    const RenderSettings settings = flat_settings();
    const OneLight integrator(64, 1);
    sample_rates(flat_camera(), integrator, settings, {{0, 0}, {width - 1, height - 1}});
    REQUIRE(integrator.points.size() > 100);
    std::vector<Vec2> own;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const PixelSamples pixel(x, y, settings.seed);
            for (std::uint32_t i = 0; i < 8; ++i) own.push_back(SampleSource(pixel, i).point(77));
        }
    }
    for (const Vec2& point : integrator.points) CHECK(std::ranges::count(own, point) == 0);
}

TEST_CASE("Parts of an image with more samples at outlines have no sample in common", "[rates]") {
    RenderSettings settings = flat_settings();
    const Rendering whole = render(flat_camera(), Numbers(), settings);
    CHECK(preferred(whole) == 9);
    settings.parts = 2;
    const Rendering first = render(flat_camera(), Numbers(), settings);
    settings.part = 2;
    const Rendering second = render(flat_camera(), Numbers(), settings);
    for (std::size_t i = 0; i < whole.film.size(); ++i) {
        CHECK(first.film.counts()[i] + second.film.counts()[i] == whole.film.counts()[i]);
        CHECK(first.film.sum(i).x + second.film.sum(i).x == Approx(whole.film.sum(i).x));
    }
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
