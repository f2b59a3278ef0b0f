#pragma once

#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/camera_sampler.h"
#include "core/render/image_film.h"

namespace etalon {

/// Samples of neighbouring pixels on their way to the film: collected until there are as many as an
/// integrator does best to get at a time. To be used for one tile after another, by one thread at a
/// time.
class SampleBatch {
  public:
    /// All three must outlive the batch.
    SampleBatch(const CameraSampler& camera, const Integrator& integrator, ImageFilm& film);

    /// Begins a tile, to which no other thread may add samples; `counts` gets its rays.
    void begin(RayCounts& counts);

    /// How many samples can be added at least; never 0.
    std::uint32_t room() const;

    /// Adds the samples [first, last) of the pixel (x, y), at most room() of them.
    void add(int x, int y, std::uint32_t first, std::uint32_t last);

    /// Renders the samples that still wait, and gives them to the film.
    void finish();

    /// Number of samples of the tile that are in the film.
    std::uint64_t done() const { return done_; }

    /// Number of those that were not finite.
    std::uint64_t dropped() const { return dropped_; }

  private:
    void render_weighted(const CameraSamples& samples, std::span<Color> colors);

    CameraBatch samples_;
    const Integrator& integrator_;
    ImageFilm& film_;
    RayCounts* counts_ = nullptr;
    std::vector<Color> colors_;
    RayBuffer weighted_rays_;  ///< of a camera with weights, those above 0
    std::vector<ShutterTime> weighted_times_;
    std::vector<SampleSource> weighted_sources_;
    std::vector<Color> weighted_colors_;
    std::uint64_t done_ = 0, dropped_ = 0;
};

}  // namespace etalon
