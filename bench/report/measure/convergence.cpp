#include <fmt/format.h>

#include "bench/report/commands.h"
#include "bench/report/measure/rendered.h"
#include "bench/report/words.h"
#include "core/image/metrics/metrics.h"

namespace etalon::bench_report {
namespace {

/// The seconds without those in which the error is measured.
ConvergenceCurve curve_of(const std::string& name, const Scene& scene,
                          const std::vector<Color>& reference, RenderOptions options) {
    ConvergenceCurve curve{name, {}};
    Stopwatch watch;
    double seconds = 0;
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

/// Samples anywhere; evenly; and where they help, until the error is what it was before.
std::vector<ConvergenceCurve> curves_of(const Scene& scene, const std::vector<Color>& reference,
                                        RenderOptions options) {
    std::vector<ConvergenceCurve> curves;
    options.sampler = Sampler::random;
    curves.push_back(curve_of("random", scene, reference, options));
    options.sampler = Sampler::sobol;
    curves.push_back(curve_of("sobol", scene, reference, options));
    if (curves.back().points.empty()) return curves;
    options.error = curves.back().points.back().error;
    options.variance = true;
    options.samples_per_pixel *= 16;
    curves.push_back(curve_of("adaptive", scene, reference, options));
    return curves;
}

void measure(const ConvergenceRequest& request, Results& results, const Context& context) {
    const std::optional<Scene> scene = shipped_scene(request.scene, request.width, request.height);
    if (!scene) return;
    RenderOptions options = options_for(*scene, context.part(0, 0.7));
    options.samples_per_pixel = request.reference_samples;
    options.seed = 1;
    const Rendered reference = rendered(*scene, "bvh", options);
    if (!reference.rendering.complete) return;
    options.samples_per_pixel = request.samples;
    options.seed = 0;
    options.progress = nullptr;
    ConvergenceFigures figures{
        fmt::format("{}, {} × {} pixels", request.scene, request.width, request.height),
        convergence_command(results.settings),
        fmt::format("{} samples a pixel, of another seed", request.reference_samples),
        curves_of(*scene, reference.rendering.film.pixels(), options)};
    if (!context.is_over()) results.convergence.add(std::move(figures));
}

}  // namespace

std::vector<Task> convergence_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const ConvergenceRequest& request : settings.convergence) {
        const double samples = 1.0 * request.width * request.height *
                               (request.reference_samples + 3.0 * request.samples);
        tasks.push_back({"convergence of " + request.scene,
                         0.1 + 0.5e-6 * request.microseconds * samples,
                         [request](Results& results, const Context& context) {
                             measure(request, results, context);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
