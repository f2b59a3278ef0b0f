#include <fmt/format.h>

#include "bench/report/commands.h"
#include "bench/report/measure/rendered.h"
#include "bench/report/words.h"
#include "core/image/metrics/metrics.h"

namespace etalon::bench_report {
namespace {

/// A way to place samples.
struct Way {
    const char* name;
    Sampler sampler;
    double error;  ///< above 0: samples go where they help
};

/// The error asked for of adaptive samples is one that they do not reach.
constexpr Way ways[] = {{"random", Sampler::random, 0},
                        {"sobol", Sampler::sobol, 0},
                        {"adaptive", Sampler::sobol, 1e-9}};

/// The seconds without those in which the error is measured.
ConvergenceCurve curve_of(const Scene& scene, const Way& way, const std::vector<Color>& reference,
                          RenderOptions options) {
    ConvergenceCurve curve{way.name, {}};
    Stopwatch watch;
    double seconds = 0;
    options.sampler = way.sampler;
    options.error = way.error;
    options.variance = way.error > 0;
    options.after_round = [&](const RenderedRound& round) {
        seconds += watch.lap().cpu;
        const double samples =
            static_cast<double>(round.film.total_count()) / static_cast<double>(round.film.size());
        curve.points.push_back({samples, seconds, relmse(round.film.pixels(), reference)});
        watch.lap();
    };
    rendered(scene, "bvh", options);
    return curve;
}

void measure(const ConvergenceRequest& request, Results& results, const Context& context) {
    const std::optional<Scene> scene = shipped_scene(request.scene, request.width, request.height);
    if (!scene) return;
    RenderOptions options = options_for(*scene, context);
    options.samples_per_pixel = request.reference_samples;
    options.seed = 1;
    const Rendered reference = rendered(*scene, "bvh", options);
    if (!reference.rendering.complete) return;
    ConvergenceFigures figures{
        fmt::format("{}, {} × {} pixels", request.scene, request.width, request.height),
        convergence_command(results.settings),
        fmt::format("{} samples a pixel, of another seed", request.reference_samples),
        {}};
    options.samples_per_pixel = request.samples;
    options.seed = 0;
    options.progress = nullptr;
    const std::vector<Color> pixels = reference.rendering.film.pixels();
    for (const Way& way : ways) figures.curves.push_back(curve_of(*scene, way, pixels, options));
    if (!context.stop) results.convergence.add(std::move(figures));
}

}  // namespace

std::vector<Task> convergence_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const ConvergenceRequest& request : settings.convergence) {
        const double samples = request.reference_samples + 3.0 * request.samples;
        tasks.push_back({"convergence of " + request.scene,
                         0.1 + 0.6e-6 * request.width * request.height * samples,
                         [request](Results& results, const Context& context) {
                             measure(request, results, context);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
