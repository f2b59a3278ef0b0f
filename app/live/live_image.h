#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "core/render/render_observer.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// The newest pixels of an image while it is rendered, for those who show it. It takes the memory
/// of one image, however slow they are; who renders waits for them no longer than it takes to copy
/// a row of tiles.
class LiveImage {
  public:
    /// What is known of some pixels, by rows.
    struct Pixels {
        std::vector<Color> colors;  ///< as the film has them
        std::vector<std::uint32_t> samples;
        std::vector<float> seconds;  ///< processor time of samples, spread over a tile
    };

    /// What the costs of the pixels come to.
    struct Summary {
        double samples = 0;  ///< mean number of a pixel
        std::uint32_t most_samples = 0;
        float most_seconds = 0;
    };

    explicit LiveImage(const RenderSettings& settings);

    /// Returns what keeps the image up to date. In the middle of a pass a filtered image has the
    /// means of the samples in each pixel, afterwards those that the filter makes.
    RenderObserver observer();

    const RenderSettings& settings() const { return settings_; }
    const Imath::Box2i& window() const { return window_; }

    /// The window cut into tiles.
    const std::vector<Imath::Box2i>& tiles() const { return tiles_; }

    /// Number of times that a tile's pixels have changed; 0: there are none yet.
    std::uint64_t version(std::size_t tile) const { return versions_[tile]; }

    /// Sum of the versions of all tiles.
    std::uint64_t version() const;

    /// Copies of the pixels of a tile, and of all. From any thread.
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
    std::vector<std::atomic<std::uint64_t>> versions_;  ///< of the tiles
    mutable std::deque<std::mutex> mutexes_;            ///< of the rows of tiles
    Pixels pixels_;
};

}  // namespace etalon
