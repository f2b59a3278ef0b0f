#pragma once

#include <optional>
#include <set>
#include <string>

#include "app/render/arguments.h"
#include "app/render/checkpoint.h"
#include "app/stats.h"
#include "core/base/read_log.h"
#include "core/image/rendered_image.h"

namespace etalon {

/// State of a rendering that is kept beside its images, if requested: checkpoints, and the film of
/// a part.
class KeptState {
  public:
    /// Must be made before the scene is read, whose files identify the image. An image that
    /// `is_shared` by several processes always needs an identity.
    KeptState(const RenderArguments& arguments, bool is_shared);

    /// Computes the image's identity after its scene was read completely, from `path`.
    void identify(const std::string& path, const Scene& scene, const RenderSettings& settings);

    /// Prepares for the identified image. Returns why the checkpoint to resume from is unusable,
    /// beginning with its name, or an empty string.
    std::string open();

    /// Return the identity of the image, and the files of its scene; empty if they are not needed.
    const nlohmann::ordered_json& identity() const { return identity_; }
    const std::set<std::string>& scene_files() const { return scene_files_; }

    /// Makes a rendering save its state, and resume the one that was opened. The control must not
    /// outlive this.
    void attach(RunControl& control);

    /// Returns whether the resumed state did not fit the image.
    bool failed() const { return resumed_ && resumed_->failed(); }

    /// Returns whether there is a checkpoint of the image.
    bool is_resumable() const { return resumed_ || (writer_ && writer_->written() > 0); }

    /// Appends what the EXR of a part holds beside the image.
    void append_film(const RenderedImage& image, std::string& file) const;

    void fill(RenderStats& stats, const Rendering& rendering) const;

  private:
    std::string resume();
    bool is_part() const { return !part_.empty(); }

    const SceneArguments& scene_;
    std::string path_, part_;
    double every_;
    bool resumes_, is_shared_;
    std::optional<ReadLog> files_;  ///< until the scene is known
    nlohmann::ordered_json identity_;
    std::set<std::string> scene_files_;
    std::string film_;  ///< film of a part, as bytes
    std::optional<CheckpointWriter> writer_;
    CheckpointReader reader_;
    std::optional<StateReader> resumed_;
};

}  // namespace etalon
