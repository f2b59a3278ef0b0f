#pragma once

#include "core/render/camera_rays.h"
#include "core/sampling/sample_source.h"

namespace etalon {

/// The rays from the eye that make an image: one for each sample of a pixel.
class CameraSampler {
  public:
    CameraSampler(const Camera& camera, const RenderSettings& settings);

    /// Whether each ray counts for the four pixels about its corner.
    bool shares_corners() const { return shares_corners_; }

    /// Returns the points with rays of their own: a window's pixels, or the corners about them.
    Imath::Box2i sampled(Imath::Box2i window) const;

    /// Ray of one sample of the pixel, or corner, (x, y).
    Ray ray(int x, int y, const SampleSource& sample) const;

  private:
    CameraRays camera_;
    bool has_samples_, shares_corners_;
    Vec2 in_pixel_;  ///< place of the one ray of an image without samples
};

}  // namespace etalon
