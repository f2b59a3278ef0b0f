#include <fmt/format.h>

#include <numeric>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/measure/cost_map.h"
#include "bench/report/measure/rendered.h"
#include "core/image/encode.h"
#include "core/image/metrics/flip.h"
#include "core/image/metrics/magma.h"
#include "core/image/png.h"
#include "core/render/image_pixels.h"

namespace etalon::bench_report {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string samples_of(int count) {
    return count_of(static_cast<std::uint64_t>(count), "sample") + " a pixel";
}

Rendered rendered(const ShippedScene& shipped, int samples, std::uint32_t seed,
                  const TaskProgress& task_progress) {
    RenderSettings settings = shipped.settings;
    settings.samples_per_pixel = samples;
    settings.seed = seed;
    return bench_report::rendered(shipped.scene, default_backend, settings,
                                  control_of(task_progress));
}

Bytes display(const RenderSettings& settings, const std::vector<Color>& pixels) {
    const Imath::V2i& size = settings.resolution;
    return display_bytes({size.x, size.y, settings.window(), pixels, settings.display_colors, {}},
                         0);
}

/// Adds an image to `figures`, without the layer if it cannot be encoded as PNG.
void add(const std::string& title, const Bytes& rgb, ImageFigures& figures) {
    Result<std::string> png = encode_png(rgb, figures.width, figures.height);
    if (png) return figures.layers.push_back({title, std::move(png.value)});
    print_message("etalon-bench: warning: {}\n", png.error);
}

/// The brightest colour is the 99th percentile: a few extreme pixels would make all others dark.
void add_cost(const std::string& title, const PixelPlane& cost, ImageFigures& figures) {
    const double white = statistics::quantile(cost.values, 0.99);
    const double mean = std::reduce(cost.values.begin(), cost.values.end()) /
                        static_cast<double>(cost.values.size());
    add(fmt::format("{}, mean {}, pale {}", title, three_digits(mean), three_digits(white)),
        magma(cost, white), figures);
}

void measure(const ImageRequest& request, Results& results, const TaskProgress& task_progress) {
    const auto shipped = shipped_scene(request.scene, request.width, request.height);
    if (!shipped) return;
    const auto& [scene, settings] = *shipped;
    const Rendered many = rendered(*shipped, request.samples, 0, task_progress.part(0, 0.9));
    const Rendered few = rendered(*shipped, request.fewer_samples, 1, task_progress.part(0.9, 1));
    if (!many.rendering.complete || !few.rendering.complete) return;
    ImageFigures figures{request.scene,
                         image_command(request),
                         request.width,
                         request.height,
                         scene.geometry.primitives.size(),
                         many.render,
                         {}};
    const PixelPlane error = flip_map(image_pixels(few.rendering.film, settings),
                                      image_pixels(many.rendering.film, settings), request.width);
    add(samples_of(request.samples), display(settings, many.rendering.film.pixels()), figures);
    add(fmt::format("FLIP of {}, mean {}", samples_of(request.fewer_samples),
                    three_digits(flip(error))),
        magma(error), figures);
    RenderSettings fewer = settings;
    fewer.samples_per_pixel = request.fewer_samples;
    if (const auto rays = rays_of_samples(scene, fewer, task_progress)) {
        add_cost("Rays of a sample", *rays, figures);
    }
    if (const auto tests = tests_of_camera_rays(scene, settings, default_backend, task_progress)) {
        add_cost(std::string("Tests of a camera ray by ") + default_backend, *tests, figures);
    }
    results.images.add(std::move(figures));
}

}  // namespace

std::vector<Task> image_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const ImageRequest& request : settings.images) {
        const double samples =
            1.0 * request.width * request.height * (request.samples + 2 * request.fewer_samples);
        tasks.push_back({request.scene,
                         0.1 + 0.5e-6 * microseconds_of_sample(request.scene) * samples,
                         [request](Results& results, const TaskProgress& task_progress) {
                             measure(request, results, task_progress);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
