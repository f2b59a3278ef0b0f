// Samples on their way from the camera to the film.
#include <limits>
#include <stdexcept>

#include "core/render/camera_sampler.h"
#include "core/render/renderer.h"
#include "core/sampling/dimensions.h"
#include "tests/catch.h"
#include "tests/render/lens_camera.h"

using namespace etalon;
using namespace etalon::test;

namespace {

RenderSettings settings_of(const Imath::V2i& resolution, int samples) {
    RenderSettings settings;
    settings.resolution = resolution;
    settings.samples_per_pixel = samples;
    settings.seed = 3;
    return settings;
}

/// Shows functions of a sample's time and random numbers, which a camera does not.
class Recorder : public Integrator {
  public:
    static Color color(ShutterTime time, const SampleSource& source) {
        return {static_cast<float>(time * 0x1p-24), static_cast<float>(source.point(77).x), 1};
    }
    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override {
        // Not REQUIRE: this runs on several threads.
        if (samples.sources.size() != colors.size()) throw std::logic_error("sources are missing");
        for (std::size_t i = 0; i < colors.size(); ++i) {
            colors[i] = color(samples.rays[i].time(), samples.sources[i]);
        }
        counts.camera += colors.size();
    }
};

/// Shows a fourth of the samples as white; the others are not finite in one channel.
class Damaged : public Integrator {
  public:
    static Color color(const SampleSource& source) {
        const auto kind = static_cast<int>(4 * source.point(77).x);
        Color result(1.0F);
        if (kind < 3) result[kind] = (kind == 1 ? -1 : 1) * std::numeric_limits<float>::infinity();
        if (kind == 2) result.z = std::numeric_limits<float>::quiet_NaN();
        return result;
    }
    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts&) const override {
        for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = color(samples.sources[i]);
    }
};

}  // namespace

TEST_CASE("Camera rays: given a lens and motion, then each choice is of its own dimension",
          "[render]") {
    for (const Lens lens : {Lens::none, Lens::thin, Lens::system}) {
        for (const bool moves : {false, true}) {
            const Camera camera = camera_with(lens, moves);
            const RenderSettings settings = settings_of({20, 10}, 16);
            const CameraRays rays(camera, settings.resolution);
            const CameraSampler sampler(camera, settings);
            CameraBatch batch(sampler);
            batch.add(3, 4, 0, 16);
            batch.add(11, 7, 5, 9);
            const CameraSamples samples = batch.make(false);
            std::size_t i = 0;
            for (const auto& [x, y, first, last] : {std::array{3, 4, 0, 16}, {11, 7, 5, 9}}) {
                const PixelSamples pixel(x, y, settings.seed);
                for (int k = first; k < last; ++k, ++i) {
                    CAPTURE(static_cast<int>(lens), moves, i);
                    const auto point = [&](std::uint32_t dimension) {
                        return pixel.points(dimension)(static_cast<std::uint32_t>(k));
                    };
                    const Vec2 place = Vec2(x, y) + point(pixel_dimension);
                    const ShutterTime time = moves ? shutter_time(point(time_dimension).x) : 0;
                    const Ray expected = rays.ray(place, point(lens_dimension), time);
                    CHECK(batch.places()[i] == place);
                    if (!samples.weights.empty() && samples.weights[i] == 0) continue;
                    CHECK(samples.rays[i].origin == expected.origin);
                    CHECK(samples.rays[i].direction == expected.direction);
                    CHECK(samples.rays[i].time() == time);
                }
            }
            CHECK(i == samples.rays.size());
        }
    }
}

TEST_CASE("Samples: given a lens that blocks some rays, then the others are weighted", "[render]") {
    for (const bool moves : {false, true}) {
        const Camera camera = camera_with(Lens::system, moves);
        const RenderSettings settings = settings_of({30, 12}, 16);
        const Rendering rendering = render(camera, Recorder(), settings);
        const CameraSampler sampler(camera, settings);
        std::uint64_t passing = 0;
        for (int y = 0; y < 12; ++y) {
            for (int x = 0; x < 30; ++x) {
                CameraBatch batch(sampler);
                batch.add(x, y, 0, 16);
                const CameraSamples samples = batch.make(true);
                Vec3 sum(0);
                for (std::size_t i = 0; i < 16; ++i) {
                    if (samples.weights[i] == 0) continue;
                    ++passing;
                    sum += Vec3(Recorder::color(samples.rays[i].time(), samples.sources[i]) *
                                samples.weights[i]);
                }
                CAPTURE(moves, x, y);
                const std::size_t pixel = rendering.film.index(x, y);
                CHECK((rendering.film.mean(pixel) - sum / 16).length() <= 1e-6 * sum.length());
            }
        }
        CHECK(rendering.counts.camera == passing);
        CHECK((passing > 500 && passing < 16 * 30 * 12 - 500));
    }
}

TEST_CASE("Samples: given some that are not finite, then they are black and counted", "[render]") {
    RenderSettings settings = settings_of({30, 12}, 16);
    for (const double scale : {1.0, 2.0}) {
        settings.film_scale = scale;
        const Rendering rendering = render(camera_with(Lens::none, false), Damaged(), settings);
        std::uint64_t dropped = 0;
        for (int y = 0; y < 12; ++y) {
            for (int x = 0; x < 30; ++x) {
                std::uint32_t white = 0;
                for (std::uint32_t i = 0; i < 16; ++i) {
                    const SampleSource source(PixelSamples(x, y, settings.seed), i);
                    white += is_finite(Damaged::color(source)) ? 1 : 0;
                }
                dropped += 16 - white;
                CHECK(rendering.film.mean(rendering.film.index(x, y)) == Vec3(scale * white / 16));
            }
        }
        CHECK(rendering.dropped_samples == dropped);
    }
}
