#pragma once

#include "core/intersect/ray.h"
#include "core/scene/camera.h"

namespace etalon {

/// A camera worked out for making rays.
class CameraRays {
  public:
    /// Rays of `camera`; `resolution` is width and height of the image in pixels.
    CameraRays(const Camera& camera, const Imath::V2i& resolution);

    /// Returns a ray: `pixel` in pixels from the image's top left corner (centres at .5); `lens` in
    /// [0,1)^2, of no effect on a pinhole. The direction is of unit length.
    Ray ray(const Vec2& pixel, const Vec2& lens) const;

    /// How far in front of the eye a point is, along the axis of view; negative behind it.
    double depth(const Vec3& point) const { return (eye_ - point).dot(n_); }

    bool has_lens() const { return lens_radius_ > 0; }

    /// Matrix from world to a right-handed frame that looks down -z; row vectors, as in OpenEXR.
    Imath::M44d world_to_camera() const;

    /// Matrix from world to [-1,1]^2 over the image, x to the right, y upwards.
    Imath::M44d world_to_ndc() const;

  private:
    Vec3 eye_, u_, v_, n_;  ///< u right, v up, n backwards: unit vectors
    double distance_;       ///< distance of the view plane
    Vec2 pixel_size_;       ///< size on the view plane
    double width_, height_;
    double lens_radius_, focal_;
};

}  // namespace etalon
