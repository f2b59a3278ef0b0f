#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/common/reference_image.h"
#include "app/common/stopwatch.h"
#include "bench/convergence/measure_foreign.h"
#include "bench/frames/process_start.h"
#include "bench/report/tasks.h"
#include "core/formats/alters_image.h"
#include "core/formats/load.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon::bench_report {
namespace {

using namespace convergence;

/// Largest relative difference of means of images that count as the same.
constexpr double mean_limit = 5e-3;
constexpr double standard_errors = 3;

/// Returns a scene's path relative to the table's folder or to their common folder, such as
/// "killeroo/simple".
std::string name_of(const std::string& scene, const std::string& table) {
    namespace fs = std::filesystem;
    const fs::path path = fs::path(scene).lexically_relative(fs::path(table).parent_path());
    fs::path name;
    for (const fs::path& part : path) {
        if (part != "..") name /= part;
    }
    return name.replace_extension().string();
}

/// Returns why a scene's image cannot be compared with another program's; empty if it can.
std::string check_rendered_whole(const LoadResult& loaded) {
    if (!loaded.scene) return "cannot be read";
    for (const Diagnostic& d : loaded.diagnostics) {
        if (alters_image(d)) return d.message;
    }
    return {};
}

bool is_same(const Point& p) {
    for (int k = 0; k < 3; ++k) {
        const double difference = std::abs((*p.mean_difference)[k]);
        const double error = p.mean_difference_error ? (*p.mean_difference_error)[k] : 0;
        if (!(difference <= std::max(mean_limit, standard_errors * error))) return false;
    }
    return true;
}

convergence::ConvergenceConfig config_of(const Settings& settings, double reading_seconds) {
    convergence::ConvergenceConfig config;
    config.samplers = {"sobol"};
    config.samples = settings.foreign_samples;
    config.seeds = settings.foreign_seeds;
    config.reading_seconds = reading_seconds;
    return config;
}

/// Measures the curves of a scene; returns why there are none, or nothing.
std::string measure_own(const LoadResult& loaded, const convergence::ConvergenceConfig& config,
                        const ReferenceImage& reference, const TaskProgress& task_progress,
                        ForeignFigures& figures) {
    auto curves = measure(*loaded.scene, loaded.settings, reference, config,
                          {task_progress.stop, task_progress.progress});
    if (curves.empty()) return "interrupted";
    figures.own = std::move(curves.front());
    if (!figures.own.replaced_images.empty()) return figures.own.replaced_images.front();
    figures.comparisons = compare({figures.own}, figures.foreign);
    figures.is_same = is_same(figures.own.points.back());
    return {};
}

/// Compares a scene's images; returns why they cannot be, or nothing.
std::string compare_scene(const ForeignRequest& request, const Settings& settings,
                          const TaskProgress& task_progress, ForeignFigures& figures) {
    Stopwatch reading;
    LoadResult loaded = load_scene(request.scene);
    const double reading_seconds = frames::seconds_before_main() + reading.lap().cpu;
    if (std::string why = check_rendered_whole(loaded); !why.empty()) return why;
    std::vector<std::string> problems;
    make_cut_outs(*loaded.scene, problems);
    if (!problems.empty()) return problems.front();
    figures.size = loaded.settings.resolution;
    figures.reference = reference_for(request.images, request.scene);
    if (figures.reference.empty()) return "no reference image";
    auto pixels = read_reference(figures.reference, loaded.settings);
    if (!pixels) return pixels.error;
    const ReferenceImage reference{std::move(pixels.value), figures.reference};
    auto foreign = measure_foreign(request.images, reference, loaded.settings);
    if (!foreign) return foreign.error;
    figures.foreign = std::move(foreign.value);
    return measure_own(loaded, config_of(settings, reading_seconds), reference, task_progress,
                       figures);
}

void measure(const ForeignRequest& request, Results& results, const TaskProgress& task_progress) {
    ForeignFigures figures;
    figures.scene = name_of(request.scene, results.settings.foreign_table);
    figures.missing = compare_scene(request, results.settings, task_progress, figures);
    results.foreign.add(std::move(figures));
}

}  // namespace

std::vector<Task> foreign_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const ForeignRequest& request : settings.foreign) {
        tasks.push_back({"other programs' images of " + request.scene,
                         seconds_for(request, settings),
                         [request](Results& results, const TaskProgress& task_progress) {
                             measure(request, results, task_progress);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
