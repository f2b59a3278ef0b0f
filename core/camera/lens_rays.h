#pragma once

#include "core/camera/lens_tracer.h"

namespace etalon {

/// A ray from a film through a lens, in the camera's space, with its weight.
struct WeightedRay {
    LensRay ray;
    float weight;  ///< 0 if the lens blocks it; the ray is then that of a pinhole
};

/// Generates the rays of a camera with a lens of several surfaces.
class LensRays {
  public:
    /// `resolution` is the width and height of the image in pixels.
    LensRays(const LensSystem& lens, const Imath::V2i& resolution);

    /// Returns a ray; `pixel` is in pixels from the top left corner of the image; `on_pupil` in
    /// [0,1)^2.
    WeightedRay ray(const Vec2& pixel, const Vec2& on_pupil) const;

  private:
    LensTracer tracer_;
    std::vector<Imath::Box2d> exit_pupils_;
    double film_radius_, exposure_;
    Vec2 half_film_, pixel_size_;
};

}  // namespace etalon
