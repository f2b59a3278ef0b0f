#include <fmt/format.h>

#include "bench/report/measure/rendered.h"
#include "core/formats/load.h"
#include "core/render/spd_rules.h"
#include "scenes/generate/scene_text.h"

namespace etalon::bench_report {
namespace {

void measure(const SpdScene& wanted, Results& results, const TaskProgress& task_progress) {
    const std::string text = generate::scene_text(wanted.family, wanted.size);
    Stopwatch watch;
    LoadResult loaded = load_scene_text(text, wanted.family + ".p3f");
    if (!loaded.scene) return;
    Scene scene = std::move(*loaded.scene);
    apply_spd_rules(loaded.settings);
    SpdFigures figures{
        wanted.family, wanted.size, scene.geometry.primitives.size(), watch.lap().cpu, {}};
    for (const std::string& backend : results.settings.spd_backends) {
        const Rendered r = rendered(scene, backend, loaded.settings, control_of(task_progress));
        if (!r.rendering.complete) return;
        figures.runs.push_back({backend, r.build, r.render, r.bytes, r.rendering.counts});
        const auto done = static_cast<double>(figures.runs.size());
        task_progress.progress(done / static_cast<double>(results.settings.spd_backends.size()));
    }
    results.spd.add(std::move(figures));
}

}  // namespace

std::vector<Task> spd_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const SpdScene& scene : settings.spd_scenes) {
        const double seconds = 0.3 * static_cast<double>(settings.spd_backends.size());
        tasks.push_back(
            {scene.family, seconds, [scene](Results& results, const TaskProgress& task_progress) {
                 measure(scene, results, task_progress);
             }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
