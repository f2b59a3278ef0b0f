#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "core/render/render_observer.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// The newest pixels of an image during its rendering, for its viewers. It takes the memory of one
/// image, however slow they are; the renderer waits for them no longer than it takes to copy a row
/// of tiles.
class LiveImage {
  public:
    /// Data of some pixels, in rows.
    struct Pixels {
        std::vector<Color> colors;  ///< in the film's values
        std::vector<std::uint32_t> samples;
        std::vector<float> seconds;  ///< processor time of samples, averaged over a tile
    };

    /// Totals of the pixels.
    struct Summary {
        double samples = 0;  ///< mean number per pixel
        std::uint32_t most_samples = 0;
        float most_seconds = 0;
    };

    explicit LiveImage(const RenderSettings& settings);

    /// Returns an observer that updates the image. During a pass, a filtered image has the means of
    /// the samples in each pixel; afterwards, the filtered values.
    RenderObserver observer();

    const RenderSettings& settings() const { return settings_; }
    const Imath::Box2i& window() const { return window_; }

    /// Returns the tiles of the window.
    const std::vector<Imath::Box2i>& tiles() const { return tiles_; }

    /// Returns how often a tile's pixels have changed; 0: there are none yet.
    std::uint64_t version(std::size_t tile) const { return versions_[tile]; }

    /// Returns the sum of the versions of all tiles.
    std::uint64_t version() const;

    /// Return copies of the pixels of a tile, and of all. Thread-safe.
    Pixels pixels_of(std::size_t tile) const;
    Pixels pixels() const;

    Summary summary() const;

  private:
    void put_tile(const RenderedTile& rendered);
    void put_film(const Film& film);
    void put_row(const Film& film, int y, int first, int last);
    /// Appends a part of one row of tiles.
    void copy(const Imath::Box2i& part, Pixels& to) const;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - window_.min.y) * width_ + (x - window_.min.x);
    }
    std::size_t tile_at(int x, int y) const;
    std::mutex& mutex_of(int y) const;

    RenderSettings settings_;
    Imath::Box2i window_;
    int width_, tiles_across_;
    std::vector<Imath::Box2i> tiles_;
    std::vector<std::atomic<std::uint64_t>> versions_;  ///< one for each tile
    mutable std::deque<std::mutex> mutexes_;            ///< one for each row of tiles
    Pixels pixels_;
};

}  // namespace etalon
