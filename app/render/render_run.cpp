#include "app/render/render_run.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/progress.h"
#include "app/compare/metrics_report.h"
#include "app/mpi/tile_worker.h"
#include "app/render/aovs.h"
#include "app/render/fail_with.h"
#include "app/render/image_files.h"
#include "app/render/memory.h"
#include "app/render/output_image.h"
#include "app/render/summary.h"
#include "app/replaced_images.h"
#include "core/parallel/parallel.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon {
namespace {

/// Limits the threads for the lifetime of the process. When a limit is lifted, oneTBB starts more
/// threads; if memory has run out it then ends the program, or waits for ever. So the limit is
/// never lifted.
void limit_threads(int threads) {
    alignas(ThreadLimit) static std::array<std::byte, sizeof(ThreadLimit)> room;
    [[maybe_unused]] static const auto* const limit = new (room.data()) ThreadLimit(threads);
}

}  // namespace

int RenderRun::run() {
    const int status = render_and_write();
    if (is_written_) views_.show_end(*is_written_);
    return status;
}

int RenderRun::work() {
    signals_.emplace();  // the copy of the scene is removed
    limit_threads(a_.threads);
    if (const std::string error = source_.receive(); !error.empty()) {
        return fail_with(error), exit_unusable;
    }
    if (source_.is_over()) return exit_done;
    int status = prepare();
    if (status == exit_done && !build()) status = exit_unusable;
    if (status != exit_done) return status;
    render_dealt_tiles(scene_.camera, *integrator_, settings_, [&](const TileTask& task) {
        const auto find_problems = [&] {
            std::vector<std::string> problems = integrator_->late_problems();
            for (std::string& problem : problems) problem = source_.at_rank_0(problem);
            return problems;
        };
        TileWorker(ranks_, find_problems).run(task, kept_.identity());
    });
    return exit_done;
}

int RenderRun::render_and_write() {
    limit_threads(a_.threads);
    if (const int status = prepare(); status != exit_done) return status;
    if (const int status = check_image_files(a_, scene_files_); status != exit_done) return status;
    if (!open_views() || !build() || !open_kept() || !open_reference()) return exit_unusable;
    source_.send(kept_.scene_files());
    const Rendering rendering = render_image();
    if (kept_.failed()) {
        return fail_with(a_.checkpoint + ": the checkpoint does not fit the image"), exit_unusable;
    }
    if (!report_ranks()) return exit_unusable;
    warn_of_dropped_samples(scene_, a_.scene, rendering.dropped_samples);
    warn_of_missed_target(rendering);
    const bool usable = tolerates(scene_, a_.scene, late_problems());
    const bool has_image = rendering.samples > 0;
    if (!has_image) print_message("etalon: warning: stopped before the first sample: no image\n");
    const bool written = !has_image || write(rendering);
    is_written_ = has_image && written;
    if (SignalGuard::signal() != 0) return exit_signal + SignalGuard::signal();
    if (!written) return exit_not_written;
    return usable && !lacks_channels_ ? exit_done : exit_unusable;
}

int RenderRun::prepare() {
    if (a_.integrator != scene_integrator) a_.scene.options.integrator = a_.integrator;
    LoadedScene loaded = source_.load();
    if (!loaded.scene) return loaded.status;
    signals_.emplace();
    scene_ = std::move(*loaded.scene);
    settings_ = std::move(loaded.settings);
    scene_files_ = std::move(loaded.files);
    prepare_scene(a_.integrator, scene_, settings_);
    stats_.parse = watch_.lap();
    const std::string error = apply_overrides(a_, scene_, settings_);
    if (!error.empty()) return fail_with(error), exit_usage;
    if (a_.outputs.empty()) a_.outputs = {default_output(a_.scene.path)};
    if (const std::string missing = check_memory(a_, settings_); !missing.empty()) {
        return fail_with(missing), exit_unusable;
    }
    return exit_done;
}

bool RenderRun::report_ranks() const {
    if (!dealer_) return true;
    const std::string resumable =
        kept_.is_resumable() ? "; --resume goes on from " + a_.checkpoint : "";
    if (SignalGuard::signal() != 0 && !SignalGuard::is_requested()) {
        print_message(
            "etalon: rank 0 was ended by signal {}: a rank has died, or mpirun was told to "
            "end{}\n",
            SignalGuard::signal(), resumable);
    }
    const std::string error = dealer_->error();
    return error.empty() || fail_with(error + resumable);
}

std::vector<std::string> RenderRun::late_problems() const {
    std::vector<std::string> problems = integrator_->late_problems();
    if (!dealer_) return problems;
    for (std::string& problem : dealer_->problems()) problems.push_back(std::move(problem));
    return problems;
}

bool RenderRun::open_reference() {
    if (a_.reference.empty()) return true;
    const std::string error = reference_.emplace().open(a_.reference, settings_);
    watch_.lap();  // excludes building
    return error.empty() || fail_with(error);
}

bool RenderRun::open_views() {
    const std::string error = views_.open_page(settings_);
    return error.empty() || fail_with(error);
}

bool RenderRun::open_kept() {
    const std::string error = kept_.open();
    return error.empty() || fail_with(error);
}

void RenderRun::warn_of_missed_target(const Rendering& rendering) const {
    if (!rendering.misses_target) return;
    const std::string error =
        rendering.expected_error ? fmt::format("{:.2g}", *rendering.expected_error) : "unknown";
    print_message(
        "{}: warning: relMSE {} expected after {:.1f} samples per pixel; "
        "--target-error {:g} needs a larger --spp\n",
        a_.scene.path, error, rendering.samples, a_.target_error);
}

bool RenderRun::build() {
    std::vector<std::string> problems;
    make_cut_outs(scene_, problems);
    const Backend& backend = chosen_backend(settings_);
    intersector_ = backend.build(scene_.geometry);
    packets_.emplace(scene_.geometry, *intersector_, backend.exact);
    integrator_ =
        find_integrator(settings_.integrator)->make(scene_, *packets_, settings_, problems);
    if (need_materials(a_.aovs) && scene_.is_physical() && integrator_->shading() == nullptr) {
        shading_.emplace(scene_, problems);
    }
    if (!tolerates(scene_, a_.scene, problems)) return false;
    kept_.identify(source_.path_read(), scene_, settings_);
    stats_.build = watch_.lap();
    return true;
}

Rendering RenderRun::render_image() {
    std::optional<Progress> progress;
    if (!a_.quiet) progress.emplace(a_.scene.path);
    RunControl control;
    views_.attach(settings_, control);
    if (a_.time_limit > 0) control.deadline = Deadline(a_.time_limit);
    control.stop = &SignalGuard::raised();
    kept_.attach(control);
    if (dealer_) {
        dealer_->listen(kept_.identity());
        control.dealer = &*dealer_;
    }
    if (reference_) {
        reference_->start();
        control.observers.push_back(
            {.after_pass = [&](const RenderedPass& pass) { reference_->note(pass); }});
    }
    views_.set_stage(ViewState::Stage::rendering);
    if (progress) {
        control.observers.push_back({.progress = [&](double part) { progress->update(part); }});
    }
    Rendering rendering = render(scene_.camera, *integrator_, settings_, control);
    stats_.render = watch_.lap();
    views_.set_stage(ViewState::Stage::writing);
    return rendering;
}

const PhysicalShading* RenderRun::shading() const {
    return shading_ ? &*shading_ : integrator_->shading();
}

std::vector<Channel> RenderRun::make_channels(const Film& film) try {
    std::vector<std::string> missing;
    auto channels = make_aovs(a_.aovs, {scene_, *intersector_, shading(), settings_, film},
                              SignalGuard::raised(), missing);
    for (const std::string& name : missing) {
        print_message("etalon: warning: stopped before {} was made\n", name);
    }
    stats_.aovs = watch_.lap();
    return channels;
} catch (const std::bad_alloc&) {
    fail_with("--aov: not enough memory; the image is written without further channels");
    lacks_channels_ = true;
    return {};
}

bool RenderRun::write(const Rendering& rendering) {
    std::vector<Channel> channels = make_channels(rendering.film);
    fill_stats(rendering);
    RenderedImage image = make_output_image(scene_, settings_, rendering, stats_);
    image.channels = std::move(channels);
    bool written = true;
    for (const std::string& path : a_.outputs) {
        written = write_image_file(a_, path, image, kept_) && written;
    }
    stats_.write = watch_.lap();
    if (!a_.stats.empty()) written = write_json(a_.stats, stats_json(rendering)) && written;
    if (!a_.quiet && written) {
        write_message(
            summary_of(a_, scene_, rendering, stats_, reference_ ? &*reference_ : nullptr));
    }
    return written;
}

void RenderRun::fill_stats(const Rendering& rendering) {
    stats_.scene = a_.scene.path;
    stats_.format = scene_.format;
    stats_.backend = chosen_backend(settings_).name;
    stats_.integrator = find_integrator(settings_.integrator)->name;
    stats_.direct_lighting = settings_.direct_lighting;
    stats_.isa = intersector_->isa();
    stats_.threads = max_threads();
    stats_.width = settings_.resolution.x;
    stats_.height = settings_.resolution.y;
    if (settings_.samples_per_pixel > 0) stats_.samples_per_pixel = rendering.samples;
    stats_.stopped = why_stopped(rendering);
    if (a_.target_error > 0) stats_.target_error = a_.target_error;
    stats_.expected_error = rendering.expected_error;
    stats_.seed = a_.seed;
    stats_.primitives = primitive_counts(scene_);
    stats_.rays = rendering.counts;
    kept_.fill(stats_, rendering);
    stats_.dropped_samples = rendering.dropped_samples;
    stats_.scene_bytes = memory_bytes(scene_);
    stats_.accelerator_bytes = intersector_->memory_bytes();
}

std::string RenderRun::why_stopped(const Rendering& rendering) const {
    if (rendering.complete) return "";
    return SignalGuard::signal() != 0 ? "signal" : "time-limit";
}

nlohmann::ordered_json RenderRun::stats_json(const Rendering& rendering) const {
    nlohmann::ordered_json json = to_json(stats_);
    if (dealer_) json["ranks"] = dealer_->stats();
    if (reference_) {
        json["error"] = compare::as_json(reference_->metrics_of(rendering.film));
        json["convergence"] = reference_->history();
    }
    return json;
}

}  // namespace etalon
