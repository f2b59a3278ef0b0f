#include "app/render/kept_state.h"

#include <algorithm>
#include <filesystem>

#include "app/common/console.h"
#include "app/common/output.h"
#include "app/part/film_appendix.h"
#include "app/part/image_identity.h"
#include "app/part/image_metadata.h"

namespace etalon {
namespace {

/// Seconds until the first checkpoint of an image that several processes share: if one of them
/// dies, an MPI launcher gives the others little time to write one.
constexpr double shared_first_checkpoint = 5;

}  // namespace

KeptState::KeptState(const RenderArguments& a, bool is_shared)
    : scene_(a.scene),
      path_(a.checkpoint),
      part_(a.part),
      every_(a.checkpoint_every > 0 ? a.checkpoint_every : usual_checkpoint_interval),
      resumes_(a.resume),
      is_shared_(is_shared) {
    if (!path_.empty() || is_part() || is_shared) files_.emplace();
}

void KeptState::identify(const std::string& path, const Scene& scene,
                         const RenderSettings& settings) {
    if (!files_) return;
    identity_ = image_identity(scene_, files_->fingerprint(path), scene, settings);
    scene_files_ = files_->paths();
    files_.reset();
}

std::string KeptState::open() {
    if (path_.empty()) return {};
    if (resumes_) {
        if (std::string error = resume(); !error.empty()) return error;
    }
    if (const std::string error = check_writable(path_); !error.empty()) {
        print_message("etalon: warning: checkpoint {}; rendering goes on\n", error);
    }
    writer_.emplace(path_, every_, identity_);
    if (is_shared_) writer_->begin_after(std::min(every_, shared_first_checkpoint));
    return {};
}

std::string KeptState::resume() {
    std::error_code none;
    if (!std::filesystem::exists(path_, none)) {
        print_message("etalon: note: {}: no such file; rendering begins anew\n", path_);
        return {};
    }
    std::string error = reader_.open(path_, identity_);
    if (error.empty()) resumed_.emplace(reader_.state());
    return error;
}

void KeptState::attach(RunControl& control) {
    if (writer_) control.keeper = &*writer_;
    if (resumed_) control.resumed = &*resumed_;
    if (!is_part()) return;
    control.take_film = [this](const auto& save) {
        StateWriter writer([this](std::string_view bytes) { film_ += bytes; });
        save(writer);
    };
}

void KeptState::append_film(const RenderedImage& image, std::string& file) const {
    if (!is_part()) return;
    const std::string line =
        appendix_line({identity_, metadata_json(image), {one_film(identity_, film_.size())}});
    constexpr std::size_t beside = 100;  // at most: the first line, and what ends the file
    file.reserve(file.size() + line.size() + film_.size() + beside);
    write_appendix(
        line, [&](std::string_view bytes) { file += bytes; },
        [&](const StateWriter::Sink& put) { put(film_); });
}

void KeptState::fill(RenderStats& stats, const Rendering& rendering) const {
    stats.resumed_rays = rendering.resumed_counts.total();
    if (resumed_) stats.resumed_samples_per_pixel = rendering.resumed_samples;
    if (!writer_) return;
    stats.checkpoints = writer_->written();
    stats.checkpoint_seconds = writer_->seconds();
}

}  // namespace etalon
