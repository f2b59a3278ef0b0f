#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/progress.h"
#include "app/common/signals.h"
#include "app/common/started_rank.h"
#include "app/compare/metrics_report.h"
#include "app/live/live_image.h"
#include "app/live/live_page.h"
#include "app/live/tev_view.h"
#include "app/mpi/rank_dealer.h"
#include "app/mpi/tile_message.h"
#include "app/mpi/tile_worker.h"
#include "app/render/aovs.h"
#include "app/render/arguments.h"
#include "app/render/kept_state.h"
#include "app/render/memory.h"
#include "app/render/output_image.h"
#include "app/render/reference.h"
#include "app/render/scene_source.h"
#include "app/render/summary.h"
#include "app/replaced_images.h"
#include "app/stats.h"
#include "app/subcommands.h"
#include "core/image/atomic_file.h"
#include "core/image/io.h"
#include "core/parallel/parallel.h"
#include "core/render/renderer.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon {
namespace {

bool complain(const std::string& message) {
    print_message("etalon: error: {}\n", message);
    return false;
}

/// Time between two looks whether a page that stays is to go.
constexpr auto page_interval = std::chrono::milliseconds(50);

std::string default_output(const std::string& scene) {
    const std::string stem = scene == "-" ? "render" : std::filesystem::path(scene).stem().string();
    return stem + ".exr";
}

/// Limits the threads for as long as the process lives. As it lifts a limit oneTBB asks for more
/// threads: where memory has run out it then ends the program, or waits for ever.
void limit_threads(int threads) {
    [[maybe_unused]] static const auto* const limit = new ThreadLimit(threads);
}

/// One run of the subcommand, in the order things happen.
class Render {
  public:
    Render(RenderArguments arguments, Ranks& ranks) : a_(std::move(arguments)), ranks_(ranks) {
        if (ranks.size() > 1 && ranks.rank() == 0) dealer_.emplace(ranks);
    }

    int run() {
        const int status = render_and_write();
        if (page_ && is_written_) show_end();
        return status;
    }

    /// Renders tiles for rank 0, which does all the rest.
    int work() {
        limit_threads(a_.threads);
        if (const std::string error = source_.receive(); !error.empty()) {
            return complain(error), exit_unusable;
        }
        if (source_.is_over()) return exit_done;
        int status = prepare();
        if (status == exit_done && !build()) status = exit_unusable;
        if (status != exit_done) return status;
        render_dealt_tiles(scene_.camera, *integrator_, settings_, [&](const TileTask& task) {
            TileWorker(ranks_).run(task, kept_.identity());
        });
        return exit_done;
    }

    /// Whether a signal asked for the end.
    bool is_interrupted() const { return signals_.raised(); }

  private:
    int render_and_write() {
        limit_threads(a_.threads);
        if (const int status = prepare(); status != exit_done) return status;
        if (const int status = check_outputs(); status != exit_done) return status;
        if (!open_page() || !build() || !open_kept() || !open_reference()) return exit_unusable;
        source_.send(kept_.scene_files());
        const Rendering rendering = render_image();
        if (kept_.failed()) {
            return complain(a_.checkpoint + ": the checkpoint does not fit the image"),
                   exit_unusable;
        }
        if (!report_ranks()) return exit_unusable;
        warn_of_dropped_samples(rendering);
        const bool usable = tolerates(scene_, a_.scene, integrator_->late_problems());
        const bool written = rendering.counts.camera == 0 || write(rendering);
        is_written_ = written;
        if (signals_.signal() != 0) return exit_signal + signals_.signal();
        if (!written) return exit_not_written;
        return usable ? exit_done : exit_unusable;
    }

    /// Reads the scene and settles how it is to be rendered. Returns the exit status.
    int prepare() {
        LoadedScene loaded = source_.load();
        if (!loaded.scene) return loaded.status;
        scene_ = std::move(*loaded.scene);
        settings_ = std::move(loaded.settings);
        prepare_scene(a_.integrator, scene_, settings_);
        stats_.parse = watch_.lap();
        const std::string error = apply_overrides(a_, scene_, settings_);
        if (!error.empty()) return complain(error), exit_usage;
        if (a_.outputs.empty()) a_.outputs = {default_output(a_.scene.path)};
        if (const std::string missing = check_memory(settings_); !missing.empty()) {
            return complain(missing), exit_unusable;
        }
        return exit_done;
    }

    /// Says what the other ranks made of the rendering. False if one has failed.
    bool report_ranks() const {
        if (!dealer_) return true;
        const std::string resumable =
            a_.checkpoint.empty() ? "" : "; --resume goes on from " + a_.checkpoint;
        if (signals_.signal() != 0) {
            print_message(
                "etalon: rank 0 was ended by signal {}: a rank has died, or mpirun was told to "
                "end{}\n",
                signals_.signal(), resumable);
        }
        const std::string error = dealer_->error();
        return error.empty() || complain(error + resumable);
    }

    bool open_reference() {
        if (a_.reference.empty()) return true;
        const std::string error = reference_.emplace().open(a_.reference, settings_);
        watch_.lap();  // no part of the building
        return error.empty() || complain(error);
    }

    bool open_kept() {
        const std::string error = kept_.open();
        return error.empty() || complain(error);
    }

    /// Serves the page that shows the image, where there is to be one.
    bool open_page() {
        if (!a_.serve) return true;
        page_.emplace(settings_, a_.scene.path, a_.exposure, SignalGuard::interrupt);
        const std::string error = page_->start();
        if (!error.empty()) return complain("the page cannot be shown: " + error);
        print_result("{}\n", page_->address());
        return true;
    }

    /// Lets pages show the finished image before the program ends.
    void show_end() {
        page_->set_stage(ViewState::Stage::over);
        page_->wait_for_pages();
        while (a_.stay && !signals_.raised()) std::this_thread::sleep_for(page_interval);
    }

    /// Returns the exit status for outputs that cannot be had, as far as can be told before.
    int check_outputs() const {
        std::vector<std::string> paths = a_.outputs;
        if (a_.stats == "-") paths.push_back(a_.stats);
        auto [error, status] = etalon::check_outputs(paths);
        const bool uses_standard_output = std::ranges::count(paths, "-") > 0;
        if (error.empty() && a_.serve && uses_standard_output) {
            return complain("standard output has the address of the page; expected files"),
                   exit_usage;
        }
        if (error.empty() && std::ranges::count(a_.outputs, "-") > 0) {
            error = check_image_to_standard_output();
            status = exit_usage;
        }
        return error.empty() ? exit_done : (complain(error), status);
    }

    void warn_of_dropped_samples(const Rendering& rendering) const {
        if (rendering.dropped_samples == 0) return;
        print_message("{}: warning: {} samples are infinite or no number: they count as black\n",
                      a_.scene.path, rendering.dropped_samples);
    }

    bool build() {
        std::vector<std::string> problems;
        make_cut_outs(scene_, problems);
        intersector_ = chosen_backend(settings_).build(scene_.geometry);
        integrator_ =
            find_integrator(settings_.integrator)->make(scene_, *intersector_, settings_, problems);
        if (!tolerates(scene_, a_.scene, problems)) return false;
        kept_.identify(scene_, settings_);
        stats_.build = watch_.lap();
        return true;
    }

    Rendering render_image() {
        std::optional<Progress> progress;
        if (!a_.quiet) progress.emplace(a_.scene.path);
        RunControl control;
        if (!a_.tev.empty()) {
            live_.emplace(settings_);
            tev_.emplace(a_.tev, a_.scene.path, *live_);
            control.observers.push_back(live_->observer());
        }
        if (a_.time_limit > 0) control.deadline = Deadline(a_.time_limit);
        control.stop = &signals_.raised();
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
        if (page_) {
            control.estimates_error = true;
            for (const RenderObserver& o : page_->observers()) control.observers.push_back(o);
            page_->set_stage(ViewState::Stage::rendering);
        }
        if (progress) {
            control.observers.push_back({.progress = [&](double part) { progress->update(part); }});
        }
        Rendering rendering = render(scene_.camera, *integrator_, settings_, control);
        stats_.render = watch_.lap();
        if (page_) page_->set_stage(ViewState::Stage::writing);
        return rendering;
    }

    std::vector<Channel> make_channels(const Film& film) {
        std::vector<std::string> missing;
        auto channels =
            make_aovs(a_.aovs, scene_, *intersector_, film, settings_, signals_.raised(), missing);
        for (const std::string& name : missing) {
            print_message("etalon: warning: stopped before {} was made\n", name);
        }
        stats_.aovs = watch_.lap();
        return channels;
    }

    bool write(const Rendering& rendering) {
        std::vector<Channel> channels = make_channels(rendering.film);
        fill_stats(rendering);
        RenderedImage image = make_output_image(scene_, settings_, rendering, stats_);
        image.channels = std::move(channels);
        bool written = true;
        for (const std::string& path : a_.outputs) written = write_output(path, image) && written;
        stats_.write = watch_.lap();
        if (!a_.stats.empty()) written = write_json(a_.stats, stats_json(rendering)) && written;
        if (!a_.quiet && written) {
            write_message(
                summary_of(a_, scene_, rendering, stats_, reference_ ? &*reference_ : nullptr));
        }
        return written;
    }

    bool write_output(const std::string& path, const RenderedImage& image) const {
        const std::string name = path == "-" ? "standard output" : path;
        auto file = encode_image(format_name(a_, path), image, a_.exposure);
        if (!file) return complain(name + ": cannot be written: " + file.error);
        if (can_hold_channels(format_name(a_, path))) file.value += kept_.appendix(image);
        if (path == "-") return write_result(file.value);  // the end of the program says why not
        const std::string error = write_file_atomically(path, file.value);
        return error.empty() || complain(error);
    }

    void fill_stats(const Rendering& rendering) {
        stats_.scene = a_.scene.path;
        stats_.format = scene_.format;
        stats_.backend = chosen_backend(settings_).name;
        stats_.integrator = find_integrator(settings_.integrator)->name;
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

    std::string why_stopped(const Rendering& rendering) const {
        if (signals_.signal() != 0) return "signal";
        return rendering.complete ? "" : "time-limit";
    }

    nlohmann::ordered_json stats_json(const Rendering& rendering) const {
        nlohmann::ordered_json json = to_json(stats_);
        if (dealer_) json["ranks"] = dealer_->stats();
        if (reference_) {
            json["error"] = compare::as_json(reference_->metrics_of(rendering.film));
            json["convergence"] = reference_->history();
        }
        return json;
    }

    RenderArguments a_;
    Ranks& ranks_;
    KeptState kept_{a_, ranks_.size() > 1};
    SceneSource source_{a_, ranks_};
    std::optional<RankDealer> dealer_;
    SignalGuard signals_;
    Stopwatch watch_;
    Scene scene_;
    RenderSettings settings_;
    RenderStats stats_;
    std::optional<Reference> reference_;
    std::unique_ptr<Intersector> intersector_;
    std::unique_ptr<Integrator> integrator_;
    std::optional<LivePage> page_;
    bool is_written_ = false;
    std::optional<LiveImage> live_;
    std::optional<TevView> tev_;  ///< sends the last of the image when everything else is done
};

/// Time that rank 0 waits for the others to leave after a signal: one of them may have died.
constexpr double patience_after_signal = 1;

/// Runs the subcommand in this process alone, or with other ranks.
int run_first_rank(const RenderArguments& arguments, Ranks& ranks) {
    double patience = infinity;
    const int status = [&] {
        Render render(arguments, ranks);
        const int its_status = render.run();
        if (render.is_interrupted()) patience = patience_after_signal;
        return its_status;
    }();
    ranks.leave(patience);
    return status;
}

/// Runs it in a rank that says nothing but why it failed, to rank 0.
int run_other_rank(const RenderArguments& arguments, Ranks& ranks) {
    hold_messages();
    int status = exit_unusable;
    try {
        status = Render(arguments, ranks).work();
    } catch (const std::exception& e) {
        complain(e.what());
    }
    if (status != exit_done) {
        ranks.send(0, message_of(MessageKind::failure, held_messages()));
    }
    ranks.leave(infinity);
    return status;
}

int run_render(const RenderArguments& arguments) {
    Ranks ranks;
    if (const std::string error = ranks.join(); !error.empty()) {
        if (started_rank().rank == 0) complain(error);
        return exit_unusable;
    }
    return ranks.rank() == 0 ? run_first_rank(arguments, ranks) : run_other_rank(arguments, ranks);
}

}  // namespace

Action declare_render(Options& options) {
    auto arguments = std::make_shared<RenderArguments>();
    declare_render_options(options, *arguments);
    return [arguments] { return run_render(*arguments); };
}

Action declare_serve(Options& options) {
    auto arguments = std::make_shared<RenderArguments>();
    arguments->serve = true;
    declare_render_options(options, *arguments);
    options
        .add_flag("--stay", arguments->stay,
                  "Show the finished image until a signal ends the program (default: until the "
                  "pages that are open have shown it)")
        .group("Live view");
    return [arguments] { return run_render(*arguments); };
}

}  // namespace etalon
