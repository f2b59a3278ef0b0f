#pragma once

#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/camera_rays.h"

namespace etalon {

/// The rays from the eye that make an image: one for each sample of a pixel.
class CameraSampler {
  public:
    CameraSampler(const Camera& camera, const RenderSettings& settings);

    /// Returns whether each ray counts for the four pixels about its corner.
    bool shares_corners() const { return shares_corners_; }

    /// Returns the points with rays of their own: a window's pixels, or the corners about them.
    Imath::Box2i sampled(Imath::Box2i window) const;

  private:
    friend class CameraBatch;

    CameraRays camera_;
    std::uint64_t seed_;
    Sampler sampler_;
    bool has_samples_, shares_corners_;
    bool samples_time_;
    Vec2 in_pixel_;  ///< place of the one ray of an image without samples
};

/// Samples whose rays are made together. For one thread.
class CameraBatch {
  public:
    /// The sampler must outlive the batch.
    explicit CameraBatch(const CameraSampler& sampler) : sampler_(sampler) {}

    /// Adds the samples [first, last) of the pixel, or corner, (x, y).
    void add(int x, int y, std::uint32_t first, std::uint32_t last);

    std::size_t size() const { return pixels_.size(); }

    /// The pixel of each sample, in the order in which they were added.
    const std::vector<Imath::V2i>& pixels() const { return pixels_; }

    /// Where each sample lies, in pixels, in that order; as long as what make() returns.
    const std::vector<Vec2>& places() const { return places_; }

    /// Makes the rays. What is returned is valid until the next call of a member.
    CameraSamples make();

    void clear();

  private:
    void make_samples();
    void make_rays(std::span<const Vec2> on_lens);

    const CameraSampler& sampler_;
    std::vector<Imath::V2i> pixels_;
    std::vector<SampleSource> sources_;
    PointBatch in_pixel_, on_lens_, in_time_;
    std::vector<Vec2> places_;
    RayBuffer rays_;
    std::vector<ShutterTime> times_;  ///< of the rays; none: all see the scene at one
    std::vector<float> weights_;      ///< see CameraSamples
};

}  // namespace etalon
