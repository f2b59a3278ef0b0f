#include "app/render/results.h"

#include <new>
#include <optional>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/output.h"
#include "app/common/signals.h"
#include "app/compare/metrics_report.h"
#include "app/render/aovs.h"
#include "app/render/fail_with.h"
#include "app/render/image_files.h"
#include "app/render/output_image.h"
#include "app/render/summary.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// Returns the AOVs, or nothing and an error message if memory is lacking.
std::optional<std::vector<Channel>> make_channels(const FinishedRendering& f) try {
    const PreparedScene& p = f.prepared;
    std::vector<std::string> missing;
    std::vector<Channel> channels = make_aovs(
        f.arguments.aovs, {p.scene(), p.intersector(), p.shading(), p.settings(), f.rendering.film},
        SignalGuard::raised(), missing);
    for (const std::string& name : missing) {
        print_message("etalon: warning: stopped before {} was made\n", name);
    }
    return channels;
} catch (const std::bad_alloc&) {
    fail_with("--aov: not enough memory; the image is written without further channels");
    return {};
}

std::string why_stopped(const Rendering& rendering) {
    if (rendering.complete) return "";
    return SignalGuard::signal() != 0 ? "signal" : "time-limit";
}

/// Adds what the prepared scene says.
void add(const PreparedScene& prepared, RenderStats& stats) {
    const RenderSettings& settings = prepared.settings();
    stats.format = prepared.scene().format;
    stats.backend = chosen_backend(settings).name;
    stats.integrator = find_integrator(settings.integrator)->name;
    stats.direct_lighting = settings.direct_lighting;
    stats.isa = prepared.intersector().isa();
    stats.width = settings.resolution.x;
    stats.height = settings.resolution.y;
    stats.primitives = primitive_counts(prepared.scene());
    stats.scene_bytes = memory_bytes(prepared.scene());
    stats.accelerator_bytes = prepared.intersector().memory_bytes();
}

/// Adds what the rendering reached.
void add(const Rendering& rendering, RenderStats& stats) {
    stats.stopped = why_stopped(rendering);
    stats.expected_error = rendering.expected_error;
    stats.rays = rendering.counts;
    stats.dropped_samples = rendering.dropped_samples;
}

void fill_stats(const FinishedRendering& f, RenderStats& stats) {
    stats.scene = f.arguments.scene.path;
    stats.seed = f.arguments.seed;
    if (f.arguments.target_error > 0) stats.target_error = f.arguments.target_error;
    stats.threads = max_threads();
    add(f.prepared, stats);
    add(f.rendering, stats);
    if (f.prepared.settings().samples_per_pixel > 0) {
        stats.samples_per_pixel = f.rendering.samples;
    }
    f.kept.fill(stats, f.rendering);
}

nlohmann::ordered_json stats_json(const FinishedRendering& f, const RenderStats& stats) {
    nlohmann::ordered_json json = to_json(stats);
    if (f.dealer != nullptr) json["ranks"] = f.dealer->stats();
    if (f.reference != nullptr) {
        json["error"] = compare::as_json(f.reference->metrics_of(f.rendering.film));
        json["convergence"] = f.reference->history();
    }
    return json;
}

bool write_images(const FinishedRendering& f, const RenderedImage& image) {
    bool written = true;
    for (const std::string& path : f.arguments.outputs) {
        written = write_image_file(f.arguments, path, image, f.kept) && written;
    }
    return written;
}

}  // namespace

WrittenResults write_results(const FinishedRendering& f, RenderStats& stats, Stopwatch& watch) {
    auto channels = make_channels(f);
    if (channels) stats.aovs = watch.lap();
    fill_stats(f, stats);
    const Scene& scene = f.prepared.scene();
    RenderedImage image = make_output_image(scene, f.prepared.settings(), f.rendering, stats);
    if (channels) image.channels = std::move(*channels);
    bool written = write_images(f, image);
    stats.write = watch.lap();
    const RenderArguments& a = f.arguments;
    if (!a.stats.empty()) written = write_json(a.stats, stats_json(f, stats)) && written;
    if (!a.quiet && written) {
        write_message(summary_of(a, scene, f.rendering, stats, f.reference));
    }
    return {written, channels.has_value()};
}

}  // namespace etalon
