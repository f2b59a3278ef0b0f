#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/common/signals.h"
#include "app/mpi/rank_dealer.h"
#include "app/render/arguments.h"
#include "app/render/kept_state.h"
#include "app/render/live_views.h"
#include "app/render/prepared_scene.h"
#include "app/render/reference.h"
#include "app/render/scene_source.h"
#include "app/stats.h"
#include "core/render/renderer.h"

namespace etalon {

/// One run of the subcommand, in the only process or in rank 0; members are in the order of the
/// steps.
class RenderRun {
  public:
    RenderRun(RenderArguments arguments, Ranks& ranks);

    /// Renders the image and writes it. Returns the exit status.
    int run();

    /// Returns whether a signal requested the end.
    bool is_interrupted() const { return SignalGuard::raised(); }

  private:
    int render_and_write();

    /// Loads the scene and checks what else is given. Returns the exit status.
    int open();
    bool build();
    bool open_reference();
    Rendering render_image();

    /// Writes what was rendered. Returns the exit status.
    int finish(const Rendering& rendering);

    /// Reports how the other ranks took part. Returns false if one has failed.
    bool report_ranks() const;

    /// Returns why images were replaced during the rendering, in any rank.
    std::vector<std::string> late_problems() const;
    void warn_of_missed_target(const Rendering& rendering) const;

    RenderArguments a_;
    Ranks& ranks_;
    KeptState kept_{a_, ranks_.size() > 1};
    SceneSource source_{a_, ranks_};
    std::optional<RankDealer> dealer_;
    std::optional<SignalGuard> signals_;  ///< once there is something to save
    Stopwatch watch_;
    PreparedScene prepared_{a_};
    RenderStats stats_;
    std::optional<Reference> reference_;
    std::optional<bool> is_written_;  ///< the image, once rendering is over
    LiveViews views_{a_};             ///< declared last, so that they end first
};

}  // namespace etalon
