#pragma once

#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/camera_rays.h"
#include "core/sampling/pixel_ranges.h"

namespace etalon {

/// Generates the camera rays of an image: one for each sample of a pixel.
class CameraSampler {
  public:
    CameraSampler(const Camera& camera, const RenderSettings& settings);

    /// Returns whether each ray counts for the four pixels around its corner.
    bool shares_corners() const { return shares_corners_; }

    /// Returns the points that have rays of their own: a window's pixels, or the corners around
    /// them.
    Imath::Box2i sampled(Imath::Box2i window) const;

  private:
    friend class CameraBatch;

    CameraRays camera_;
    std::uint64_t seed_;
    Sampler sampler_;
    bool has_samples_, shares_corners_;
    bool samples_time_;
    Vec2 in_pixel_;  ///< position of the single ray of a pixel without samples
};

/// Samples whose rays are generated together. For one thread.
class CameraBatch {
  public:
    /// The sampler must outlive the batch.
    explicit CameraBatch(const CameraSampler& sampler)
        : sampler_(sampler), ranges_(sampler.seed_, sampler.sampler_) {}

    /// Adds the samples [first, last) of the pixel, or corner, (x, y).
    void add(int x, int y, std::uint32_t first, std::uint32_t last) {
        ranges_.add(x, y, first, last);
    }

    std::size_t size() const { return ranges_.samples(); }

    /// Return the pixels of the samples, and the position of each, in pixels; valid as long as
    /// make()'s result.
    std::span<const PixelRun> runs() const { return ranges_.runs(); }
    std::span<const Vec2> places() const { return places_; }

    /// Generates the rays, with the sources of random numbers if they are used. The result is valid
    /// until the next call of a member.
    CameraSamples make(bool uses_sources);

    void clear() { ranges_.clear(); }

  private:
    void make_samples();
    void move_to_pixels();
    void make_rays();

    const CameraSampler& sampler_;
    PixelRanges ranges_;
    std::vector<SampleSource> sources_;
    std::vector<Vec2> places_, on_lens_, in_time_;
    RayBuffer rays_;
    std::vector<ShutterTime> times_;  ///< times of the rays; empty if all are the same
    std::vector<float> weights_;      ///< see CameraSamples
};

}  // namespace etalon
