#include "bench/frames/measure_frame.h"
#include "bench/report/measure/rendered.h"
#include "bench/scenes/bench_scene.h"

namespace etalon::bench_report {
namespace {

void measure(const std::string& name, Results& results) {
    Stopwatch watch;
    std::optional<ShippedScene> shipped = shipped_scene(name);
    if (!shipped) return;
    const double load = watch.lap().cpu;
    bench::set_width(shipped->settings.resolution, results.settings.frame_width);
    shipped->settings.samples_per_pixel = results.settings.frame_samples;
    frames::FrameFigures figures =
        frames::measure_frame(shipped->scene, shipped->settings, results.settings.frame_repeats);
    figures.scene = name;
    figures.load = load;
    results.frames.add(figures);
}

}  // namespace

std::vector<Task> frame_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const std::string& scene : settings.frame_scenes) {
        // Two renderings and, each time, about one and a half more.
        const double renderings = 2 + 1.5 * settings.frame_repeats;
        const double pixels = 0.7 * settings.frame_width * settings.frame_width;
        const double samples = pixels * settings.frame_samples;
        tasks.push_back({"frames of " + scene,
                         1e-6 * renderings * samples * microseconds_of_sample(scene),
                         [scene](Results& results, const TaskProgress& task_progress) {
                             if (!task_progress.is_over()) measure(scene, results);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
