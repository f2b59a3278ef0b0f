#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/common/signals.h"
#include "app/mpi/rank_dealer.h"
#include "app/render/arguments.h"
#include "app/render/kept_state.h"
#include "app/render/live_views.h"
#include "app/render/reference.h"
#include "app/render/scene_source.h"
#include "app/stats.h"
#include "core/integrators/integrator.h"
#include "core/intersect/intersector.h"
#include "core/intersect/packet_intersector.h"
#include "core/render/renderer.h"
#include "core/shading/physical_shading.h"

namespace etalon {

/// One run of the subcommand; members are in the order of the steps.
class RenderRun {
  public:
    RenderRun(RenderArguments arguments, Ranks& ranks) : a_(std::move(arguments)), ranks_(ranks) {
        if (ranks.size() > 1 && ranks.rank() == 0) dealer_.emplace(ranks);
    }

    /// Renders the image and writes it. Returns the exit status.
    int run();

    /// Renders tiles for rank 0, which does everything else. Returns the exit status.
    int work();

    /// Returns whether a signal requested the end.
    bool is_interrupted() const { return SignalGuard::raised(); }

  private:
    int render_and_write();

    /// Reads the scene and determines the settings. Returns the exit status.
    int prepare();

    bool build();
    bool open_views();
    bool open_kept();
    bool open_reference();
    Rendering render_image();

    /// Reports how the other ranks took part. Returns false if one has failed.
    bool report_ranks() const;

    /// Returns why images were replaced during the rendering, in any rank.
    std::vector<std::string> late_problems() const;
    void warn_of_missed_target(const Rendering& rendering) const;

    /// Returns the evaluated materials of a physical look, for AOVs.
    const PhysicalShading* shading() const;

    bool write(const Rendering& rendering);
    /// Returns the AOVs, or nothing and an error message if memory is lacking.
    std::vector<Channel> make_channels(const Film& film);
    void fill_stats(const Rendering& rendering);
    std::string why_stopped(const Rendering& rendering) const;
    nlohmann::ordered_json stats_json(const Rendering& rendering) const;

    RenderArguments a_;
    Ranks& ranks_;
    KeptState kept_{a_, ranks_.size() > 1};
    SceneSource source_{a_, ranks_};
    std::optional<RankDealer> dealer_;
    std::optional<SignalGuard> signals_;  ///< once there is something to save
    Stopwatch watch_;
    Scene scene_;
    RenderSettings settings_;
    std::vector<std::string> scene_files_;
    RenderStats stats_;
    std::optional<Reference> reference_;
    std::unique_ptr<Intersector> intersector_;
    std::optional<PacketIntersector> packets_;
    std::unique_ptr<Integrator> integrator_;
    std::optional<PhysicalShading> shading_;  ///< for AOVs, if the integrator has none
    std::optional<bool> is_written_;          ///< the image, once rendering is over
    bool lacks_channels_ = false;             ///< AOVs, for lack of memory
    LiveViews views_{a_};                     ///< declared last, so that they end first
};

}  // namespace etalon
