#pragma once

#include <functional>
#include <vector>

#include "core/parallel/spares.h"
#include "core/render/camera_sampler.h"
#include "core/render/image_film.h"
#include "core/render/sample_batch.h"
#include "core/render/sampling_passes.h"
#include "core/render/state.h"
#include "core/render/tiles.h"
#include "core/scene/camera.h"

namespace etalon {

/// Result of rendering a tile, beside its film.
struct TileResult {
    RayCounts counts;
    std::uint64_t samples = 0, dropped = 0;
    double seconds = 0;  ///< of processor time; see TileRenderer::measures_seconds
};

/// An image's film, and how a tile of it gets the samples that it lacks. Tiles are identified by
/// their numbers; threads may render different tiles at the same time.
class TileRenderer {
  public:
    /// Camera and integrator must outlive the renderer.
    TileRenderer(const Camera& camera, const Integrator& integrator,
                 const RenderSettings& settings);

    const ImageFilm& film() const { return film_; }
    ImageFilm& film() { return film_; }

    /// Calls visit(film) with the image that the samples make so far.
    template <class Visit>
    void with_image(const Visit& visit) const {
        if (film_.is_filtered()) return visit(film_.filtered());
        if (rays_.shares_corners()) return visit(film_.samples().cells());
        visit(film_.samples());
    }

    /// Takes the finished image.
    Film take_image();

    std::size_t count() const { return tiles_.size(); }

    /// Returns the tile's pixels, inclusive on both ends.
    const Imath::Box2i& tile(std::size_t number) const { return tiles_[number]; }

    /// Returns the numbers of the tiles that have not reached the goal.
    std::vector<std::size_t> unfinished_tiles() const;

    /// Adds samples to the pixels of a tile until they reach the goal, or until interrupted(),
    /// which is asked after each batch of samples.
    TileResult render(std::size_t tile, const std::function<bool()>& interrupted);

    /// Transfers what another process needs to render a tile: the goals of its pixels, and the
    /// contents of its film.
    template <class Bytes>
    void transfer_task(std::size_t tile, Bytes& bytes) {
        for_each_pixel(tiles_[tile], [&](int x, int y) {
            const std::size_t pixel = film_.samples().index(x, y);
            std::uint32_t pixel_goal = goal.of(pixel);
            bytes(pixel_goal);
            if (!goal.of_pixel.empty()) goal.of_pixel[pixel] = pixel_goal;
        });
        transfer_film(tile, bytes);
    }

    /// Transfers the contents of a tile's film.
    template <class Bytes>
    void transfer_film(std::size_t tile, Bytes& bytes) {
        film_.transfer(bytes, tiles_[tile]);
    }

    SamplingGoal goal;

    /// Whether render() measures the time. For a thread's processor time the kernel locks the
    /// processor's queue, which takes a microsecond.
    bool measures_seconds = true;

  private:
    std::uint32_t first_sample(std::size_t pixel) const;
    bool add_pixel(int x, int y, const std::function<bool()>& interrupted,
                   SampleBatch& batch) const;

    const std::uint32_t first_sample_;  ///< number of the first sample at a rate of 1
    const Integrator& integrator_;
    CameraSampler rays_;
    ImageFilm film_;
    std::vector<Imath::Box2i> tiles_;
    Spares<SampleBatch> batches_;
};

}  // namespace etalon
