// Several processes that render one image: each has the whole scene, and one of them deals the
// tiles of a pass. What is sent of a tile is all that its film holds, so that samples are added to
// it in the order of a single process, to the same bits.
#pragma once

#include <functional>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/state.h"
#include "core/scene/camera.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// A pass, as the process that deals it sees it. Tiles are known by their numbers; different ones
/// may be rendered, written and read at the same time.
struct DealtPass {
    std::vector<std::size_t> tiles;                               ///< those that lack samples
    std::function<void(std::size_t)> render{};                    ///< renders a tile here
    std::function<void(std::size_t, StateWriter&)> write_task{};  ///< for another process
    std::function<void(std::size_t, StateReader&)> read_result{};
    std::function<bool()> interrupted{};  ///< no further tile is to be begun
    std::function<bool()> stopped{};      ///< nor is any result waited for
};

/// Deals tiles to this process and others.
class TileDealer {
  public:
    virtual ~TileDealer() = default;

    /// Renders the tiles, on all threads. When it returns all results that were waited for have
    /// been read, and the pass is called no more.
    virtual void deal(const DealtPass& pass) = 0;

    /// Returns whether another process has failed, so that rendering is to stop. From any thread.
    virtual bool has_failed() const = 0;
};

/// Renders one tile for the process that deals: reads its task, writes its result. For several
/// threads, each with another tile.
using TileTask = std::function<void(std::size_t tile, StateReader& task, StateWriter& result,
                                    const std::function<bool()>& stopped)>;

/// Calls `serve` with what renders tiles of the image of these settings, which are those of the
/// process that deals.
void render_dealt_tiles(const Camera& camera, const Integrator& integrator,
                        const RenderSettings& settings,
                        const std::function<void(const TileTask&)>& serve);

}  // namespace etalon
