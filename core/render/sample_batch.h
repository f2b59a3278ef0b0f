#pragma once

#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/camera_sampler.h"
#include "core/render/image_film.h"

namespace etalon {

/// Collects samples of neighbouring pixels until there are as many as an integrator processes best
/// in one call, then renders them and adds them to the film. To be used for one tile after another,
/// by one thread at a time.
class SampleBatch {
  public:
    /// All three must outlive the batch.
    SampleBatch(const CameraSampler& camera, const Integrator& integrator, ImageFilm& film);

    /// Begins a tile, to which no other thread may add samples. Its rays are added to `counts`.
    void begin(RayCounts& counts);

    /// Returns how many samples can be added at least; never 0.
    std::uint32_t room() const {
        return static_cast<std::uint32_t>(Integrator::batch_size - samples_.size());
    }

    /// Adds the samples [first, last) of the pixel (x, y), at most room() of them. Returns true if
    /// this filled the batch, which then was rendered.
    bool add(int x, int y, std::uint32_t first, std::uint32_t last) {
        samples_.add(x, y, first, last);
        const bool is_full = room() == 0;
        if (is_full) finish();
        return is_full;
    }

    /// Renders the pending samples and adds them to the film.
    void finish();

    /// Returns the number of samples of the tile that are in the film.
    std::uint64_t done() const { return done_; }

    /// Returns the number of those that were not finite.
    std::uint64_t dropped() const { return dropped_; }

  private:
    void render_weighted(const CameraSamples& samples, std::span<Color> colors);

    CameraBatch samples_;
    const Integrator& integrator_;
    ImageFilm& film_;
    RayCounts* counts_ = nullptr;
    std::vector<Color> colors_;
    RayBuffer weighted_rays_;  ///< for a camera with weights, the rays with weights above 0
    std::vector<ShutterTime> weighted_times_;
    std::vector<SampleSource> weighted_sources_;
    std::vector<Color> weighted_colors_;
    std::uint64_t done_ = 0, dropped_ = 0;
};

}  // namespace etalon
