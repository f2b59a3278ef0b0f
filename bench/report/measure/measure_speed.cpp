#include <fmt/format.h>

#include "app/common/console.h"
#include "bench/report/tasks.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/measured_scene.h"

namespace etalon::bench_report {
namespace {

void measure(const std::string& name, Results& results, const TaskProgress& task_progress) {
    bench::NamedScene named = bench::bench_scene(name);
    write_message(named.messages);
    if (!named.scene) return;
    const speed::SpeedConfig& config = results.settings.speed_config;
    const auto show = [&](const speed::SceneFigures& figures) {
        const auto done = static_cast<double>(figures.kinds.size() + 1);
        task_progress.progress(done / static_cast<double>(config.kinds.size() + 1));
    };
    const auto is_over = [&] { return task_progress.is_over(); };
    speed::SceneFigures figures = speed::measure_scene(
        name, std::move(*named.scene), named.settings.resolution, config, {show, is_over});
    if (!figures.builds.empty()) results.scenes.add(std::move(figures));
}

/// Estimates the time: a ray takes about a microsecond with any tracer.
double seconds_for(const speed::SpeedConfig& config) {
    const auto rays = static_cast<double>(config.max_rays * config.kinds.size() * config.repeats);
    const auto ways = static_cast<double>(config.tracers.size() * config.threads.size());
    const double checking = 2 * config.oracle_seconds * static_cast<double>(config.kinds.size());
    return 0.5 + rays * ways * 0.6e-6 + 0.5 * checking;
}

}  // namespace

std::vector<Task> speed_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const std::string& name : settings.speed_scenes) {
        tasks.push_back({name, seconds_for(settings.speed_config),
                         [name](Results& results, const TaskProgress& task_progress) {
                             measure(name, results, task_progress);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
