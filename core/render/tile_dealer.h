// Several processes that render one image. Each has the whole scene, and one of them deals the
// tiles of a pass. A tile is sent with the whole contents of its film, so that samples are added in
// the order of a single process, with the same bits.
#pragma once

#include <functional>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/state.h"
#include "core/scene/camera.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// A pass, as the process that deals it sees it. Tiles are identified by their numbers; different
/// ones may be rendered, written and read at the same time.
struct DealtPass {
    std::vector<std::size_t> tiles;                               ///< the tiles that lack samples
    std::function<void(std::size_t)> render{};                    ///< renders a tile here
    std::function<void(std::size_t, StateWriter&)> write_task{};  ///< for another process
    std::function<void(std::size_t, StateReader&)> read_result{};
    std::function<bool()> interrupted{};  ///< if true, no tile is begun and no result waited for
};

/// Deals tiles to this process and others.
class TileDealer {
  public:
    virtual ~TileDealer() = default;

    /// Renders the tiles, on all threads. When it returns, the pass is no longer used. Unless it
    /// was interrupted, all results have been read; otherwise those of other processes that are
    /// missing are expected by the next call, for the rest of the same pass.
    virtual void deal(const DealtPass& pass) = 0;

    /// Returns whether another process has failed, so that rendering must stop. Thread-safe.
    virtual bool has_failed() const = 0;
};

/// Renders one tile for the process that deals: reads its task, writes its result. Several threads
/// may call it, each with another tile.
using TileTask = std::function<void(std::size_t tile, StateReader& task, StateWriter& result,
                                    const std::function<bool()>& stopped)>;

/// Calls `serve` with a TileTask for the image with these settings, which must be those of the
/// process that deals.
void render_dealt_tiles(const Camera& camera, const Integrator& integrator,
                        const RenderSettings& settings,
                        const std::function<void(const TileTask&)>& serve);

}  // namespace etalon
