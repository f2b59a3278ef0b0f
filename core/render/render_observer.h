// What a rendering tells while it runs: how far it is, each tile as it comes, the image after each
// pass. The line of progress, references and live views all observe it so.
#pragma once

#include <functional>
#include <optional>

#include "core/render/film.h"

namespace etalon {

/// A tile to which samples were added.
struct RenderedTile {
    const Film& samples;       ///< those of the tile's pixels may be read, of no others
    const Imath::Box2i& tile;  ///< pixels, inclusive on both ends; some may be beyond the image
    double seconds;            ///< processor time that its samples took
};

/// An image as it is after a pass, or after what a stop left of it.
struct RenderedPass {
    const Film& film;
    std::optional<double> expected_error;  ///< relMSE, where it was estimated
};

/// Functions that a rendering calls; each may be empty, and is then not paid for. They change no
/// pixel, but hold the thread that calls them.
struct RenderObserver {
    /// Called with the fraction of the work that is done, from any thread.
    std::function<void(double)> progress{};
    /// Called from the thread that rendered the tile, before anything else is done to it.
    std::function<void(const RenderedTile&)> after_tile{};
    /// Called between passes, where there is anything new.
    std::function<void(const RenderedPass&)> after_pass{};
};

}  // namespace etalon
