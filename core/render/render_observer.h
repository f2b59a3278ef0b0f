// Events of a rendering while it runs: its progress, each finished tile, and the image after each
// pass. The line of progress, references and live views all observe it this way.
#pragma once

#include <functional>
#include <optional>

#include "core/render/film.h"

namespace etalon {

/// A tile to which samples were added.
struct RenderedTile {
    const Film& samples;       ///< only the tile's pixels may be read
    const Imath::Box2i& tile;  ///< pixels, inclusive on both ends; some may be beyond the image
    double seconds;            ///< processor time of its samples
};

/// An image after a pass, or as a stop left it.
struct RenderedPass {
    const Film& film;
    std::optional<double> expected_error;  ///< relMSE, if it was estimated
    double samples;                        ///< mean per pixel
};

/// Callbacks of a rendering; empty ones cost nothing. They change no pixel, but block the thread
/// that calls them.
struct RenderObserver {
    /// Called with the fraction of the work that is done, from any thread.
    std::function<void(double)> progress{};
    /// Called from the thread that rendered the tile, before anything else is done to it.
    std::function<void(const RenderedTile&)> after_tile{};
    /// Called between passes, if there is anything new.
    std::function<void(const RenderedPass&)> after_pass{};
};

}  // namespace etalon
