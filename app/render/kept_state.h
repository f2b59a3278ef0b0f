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

/// What outlives a rendering beside its images, where it is asked for: checkpoints to go on from,
/// and the film of a part.
class KeptState {
  public:
    /// To be made before the scene is read, whose files identify the image; that is needed in any
    /// case where the image `is_shared` by several processes.
    KeptState(const RenderArguments& arguments, bool is_shared);

    /// Tells the image's identity once its scene was read whole.
    void identify(const Scene& scene, const RenderSettings& settings);

    /// Prepares for the image that was identified. Returns why the checkpoint to resume from is
    /// unusable, beginning with its name, or nothing.
    std::string open();

    /// Identity of the image, and the files of its scene; nothing where nobody needs them.
    const nlohmann::ordered_json& identity() const { return identity_; }
    const std::set<std::string>& scene_files() const { return scene_files_; }

    /// Lets a rendering keep its state, and go on from the one that was opened. The control must
    /// not outlive this.
    void attach(RunControl& control);

    /// Returns whether a state that was resumed from did not fit the image.
    bool failed() const { return resumed_ && resumed_->failed(); }

    /// What stands behind the image in the EXR of a part; nothing for other images.
    std::string appendix(const RenderedImage& image) const;

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
    std::string film_;  ///< of a part, as bytes
    std::optional<CheckpointWriter> writer_;
    CheckpointReader reader_;
    std::optional<StateReader> resumed_;
};

}  // namespace etalon
