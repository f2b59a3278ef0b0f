#include "core/render/sample_rates.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/luminance.h"
#include "core/numerics/pixel_window.h"
#include "core/parallel/parallel.h"
#include "core/render/camera_sampler.h"

namespace etalon {
namespace {

constexpr int highest_rate = 16;

/// A pixel's rate is the step of emission around it, divided by this many times the mean of the
/// scattered light. Between 1 and 16 the product of error and time hardly depends on it.
constexpr double step_to_rate = 16;

/// Approximate number of samples that measure the scattered light.
constexpr int probes = 1024;

/// Returns the luminance of the emission at the centres of the pixels of a window, in rows.
std::vector<float> emission(const Camera& camera, const Integrator& integrator,
                            RenderSettings settings, const Imath::Box2i& window) {
    settings.samples_per_pixel = 0;
    settings.pixel_rays = PixelRays::centre;
    const CameraSampler sampler(camera, settings);
    const Imath::V2i size = window_size(window);
    std::vector<float> result(static_cast<std::size_t>(size.x) * size.y);
    parallel_for(size.y, 1, [&](std::size_t begin, std::size_t end) {
        CameraBatch batch(sampler);
        std::vector<Color> colors(size.x);
        for (std::size_t row = begin; row < end; ++row) {
            const int y = window.min.y + static_cast<int>(row);
            for (int x = window.min.x; x <= window.max.x; ++x) batch.add(x, y, 0, 1);
            integrator.emission(batch.make(integrator.uses_sources()), colors);
            std::ranges::transform(colors, &result[row * size.x],
                                   [](const Color& color) { return luminance(color); });
            batch.clear();
        }
    });
    return result;
}

/// Returns a mean of the luminance that surfaces scatter to the eye: the square of the mean root,
/// which few bright samples do not dominate.
double scattered_light(const Camera& camera, const Integrator& integrator,
                       RenderSettings settings) {
    settings.seed = ~settings.seed;  // other samples than those of the image
    const CameraSampler sampler(camera, settings);
    CameraBatch batch(sampler);
    const double pixels = 1.0 * settings.resolution.x * settings.resolution.y;
    const int step = std::max(1, static_cast<int>(std::sqrt(pixels / probes)));
    for (int y = step / 2; y < settings.resolution.y; y += step) {
        for (int x = step / 2; x < settings.resolution.x; x += step) batch.add(x, y, 0, 1);
    }
    std::vector<Color> all(batch.size()), emitted(batch.size());
    RayCounts not_of_the_image;
    const CameraSamples samples = batch.make(integrator.uses_sources());
    integrator.radiance(samples, all, not_of_the_image);
    integrator.emission(samples, emitted);
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double scattered = luminance(all[i]) - luminance(emitted[i]);
        if (scattered > 0 && std::isfinite(scattered)) sum += std::sqrt(scattered);
    }
    const double mean = all.empty() ? 0 : sum / static_cast<double>(all.size());
    return mean * mean;
}

/// Returns the largest power of two that is not above `rate`, within the limits.
std::uint8_t rounded_rate(double rate) {
    int result = 1;
    while (result < highest_rate && 2 * result <= rate) result *= 2;
    return static_cast<std::uint8_t>(result);
}

/// Calls `use` with the difference of the largest and the least value around each pixel of a
/// window, from values of a window that is larger by one on all sides.
template <class Use>
void for_each_step(const std::vector<float>& values, const Imath::V2i& size, const Use& use) {
    const std::size_t stride = size.x + 2;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            float least = infinity, most = 0;
            for (int v = 0; v < 3; ++v) {
                const auto row = values.begin() + static_cast<std::ptrdiff_t>((y + v) * stride + x);
                const auto [low, high] = std::minmax_element(row, row + 3);
                least = std::min(least, *low);
                most = std::max(most, *high);
            }
            use(static_cast<std::size_t>(y) * size.x + x, most - least);
        }
    }
}

}  // namespace

SampleRates sample_rates(const Camera& camera, const Integrator& integrator,
                         const RenderSettings& settings, const Imath::Box2i& window) {
    if (!integrator.shows_lights() || settings.samples_per_pixel < fewest_samples_with_rates) {
        return {};
    }
    const double scattered = scattered_light(camera, integrator, settings);
    if (!(scattered > 0)) return {};
    const Imath::V2i one(1), size = window.max - window.min + one;
    const std::vector<float> seen =
        emission(camera, integrator, settings, {window.min - one, window.max + one});
    SampleRates rates(static_cast<std::size_t>(size.x) * size.y);
    for_each_step(seen, size, [&](std::size_t pixel, double step) {
        rates[pixel] = rounded_rate(step / (step_to_rate * scattered));
    });
    const bool all_are_one = std::ranges::count(rates, 1) == std::ssize(rates);
    return all_are_one ? SampleRates{} : rates;
}

}  // namespace etalon
