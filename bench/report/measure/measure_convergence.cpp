#include "bench/convergence/measure_curves.h"

#include "bench/report/measure/rendered.h"

namespace etalon::bench_report {
namespace {

convergence::ConvergenceConfig config_of(const ConvergenceRequest& request,
                                         const Settings& settings) {
    convergence::ConvergenceConfig config;
    config.backends = settings.convergence_backends;
    config.samples = request.samples;
    config.seeds = settings.convergence_seeds;
    return config;
}

void measure(const ConvergenceRequest& request, Results& results,
             const TaskProgress& task_progress) {
    const auto shipped = shipped_scene(request.scene, request.width, request.height);
    if (!shipped) return;
    const auto& [scene, settings] = *shipped;
    const convergence::ConvergenceConfig config = config_of(request, results.settings);
    const convergence::ReferenceImage reference = render_reference(
        scene, settings, config, {task_progress.stop, task_progress.part(0, 0.5).progress});
    if (task_progress.is_over()) return;
    auto curves = convergence::measure(scene, settings, reference, config,
                                       {task_progress.stop, task_progress.part(0.5, 1).progress});
    if (curves.empty()) return;
    results.convergence.add({request, reference.description, std::move(curves)});
}

/// Estimates the time: the reference is rendered by all threads, the curves by one.
double seconds_for(const ConvergenceRequest& request, const Settings& settings) {
    const auto curves = 3.0 + static_cast<double>(settings.convergence_backends.size() - 1);
    const double samples =
        (convergence::reference_times / 2.0 + curves * settings.convergence_seeds) *
        request.samples;
    return 0.1 +
           1e-6 * microseconds_of_sample(request.scene) * samples * request.width * request.height;
}

}  // namespace

std::vector<Task> convergence_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const ConvergenceRequest& request : settings.convergence) {
        tasks.push_back({"convergence of " + request.scene, seconds_for(request, settings),
                         [request](Results& results, const TaskProgress& task_progress) {
                             measure(request, results, task_progress);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
