#pragma once

#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/camera_rays.h"

namespace etalon {

/// The rays from the eye that make an image: one for each sample of a pixel.
class CameraSampler {
  public:
    CameraSampler(const Camera& camera, const RenderSettings& settings);

    /// Whether each ray counts for the four pixels about its corner.
    bool shares_corners() const { return shares_corners_; }

    /// Returns the points with rays of their own: a window's pixels, or the corners about them.
    Imath::Box2i sampled(Imath::Box2i window) const;

    /// Appends the samples [first, last) of the pixel, or corner, (x, y).
    void append(int x, int y, std::uint32_t first, std::uint32_t last,
                std::vector<CameraSample>& samples) const;

  private:
    CameraRays camera_;
    std::uint32_t seed_;
    Sampler sampler_;
    bool has_samples_, shares_corners_;
    Vec2 in_pixel_;  ///< place of the one ray of an image without samples
};

}  // namespace etalon
