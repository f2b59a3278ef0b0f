#include "app/render/render_run.h"

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/progress.h"
#include "app/render/fail_with.h"
#include "app/render/image_files.h"
#include "app/render/results.h"
#include "app/replaced_images.h"

namespace etalon {

RenderRun::RenderRun(RenderArguments arguments, Ranks& ranks)
    : a_(std::move(arguments)), ranks_(ranks) {
    if (ranks.size() > 1) dealer_.emplace(ranks);
}

int RenderRun::run() {
    const int status = render_and_write();
    if (is_written_) views_.show_end(*is_written_);
    return status;
}

int RenderRun::render_and_write() {
    if (const int status = open(); status != exit_done) return status;
    if (!build() || !open_reference()) return exit_unusable;
    source_.send(kept_.scene_files());
    const Rendering rendering = render_image();
    if (kept_.failed()) {
        return fail_with(a_.checkpoint + ": the checkpoint does not fit the image"), exit_unusable;
    }
    return report_ranks() ? finish(rendering) : exit_unusable;
}

int RenderRun::open() {
    if (const int status = prepared_.load(source_); status != exit_done) return status;
    signals_.emplace();
    stats_.parse = watch_.lap();
    if (const int status = check_image_files(a_, prepared_.files()); status != exit_done) {
        return status;
    }
    const std::string error = views_.open_page(prepared_.settings());
    return error.empty() ? exit_done : (fail_with(error), exit_unusable);
}

bool RenderRun::build() {
    if (!prepared_.build()) return false;
    kept_.identify(source_.path_read(), prepared_.scene(), prepared_.settings());
    stats_.build = watch_.lap();
    const std::string error = kept_.open();
    return error.empty() || fail_with(error);
}

bool RenderRun::open_reference() {
    if (a_.reference.empty()) return true;
    const std::string error = reference_.emplace().open(a_.reference, prepared_.settings());
    watch_.lap();  // excludes building
    return error.empty() || fail_with(error);
}

Rendering RenderRun::render_image() {
    std::optional<Progress> progress;
    if (!a_.quiet) progress.emplace(a_.scene.path);
    RunControl control;
    views_.attach(prepared_.settings(), control);
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
    Rendering rendering =
        render(prepared_.scene().camera, prepared_.integrator(), prepared_.settings(), control);
    stats_.render = watch_.lap();
    views_.set_stage(ViewState::Stage::writing);
    return rendering;
}

int RenderRun::finish(const Rendering& rendering) {
    warn_of_dropped_samples(prepared_.scene(), a_.scene, rendering.dropped_samples);
    warn_of_missed_target(rendering);
    bool usable = tolerates(prepared_.scene(), a_.scene, late_problems());
    bool written = true;
    const bool has_image = rendering.samples > 0;
    if (has_image) {
        const WrittenResults results =
            write_results({a_, prepared_, rendering, kept_, reference_ ? &*reference_ : nullptr,
                           dealer_ ? &*dealer_ : nullptr},
                          stats_, watch_);
        written = results.files;
        usable = usable && results.channels;
    } else {
        print_message("etalon: warning: stopped before the first sample: no image\n");
    }
    is_written_ = has_image && written;
    if (SignalGuard::signal() != 0) return exit_signal + SignalGuard::signal();
    if (!written) return exit_not_written;
    return usable ? exit_done : exit_unusable;
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
    std::vector<std::string> problems = prepared_.integrator().late_problems();
    if (!dealer_) return problems;
    for (std::string& problem : dealer_->problems()) problems.push_back(std::move(problem));
    return problems;
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

}  // namespace etalon
