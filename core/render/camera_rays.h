#pragma once

#include <span>

#include "core/intersect/ray.h"
#include "core/scene/camera.h"

namespace etalon {

/// What a camera's rays are made from.
struct CameraFrame {
    Vec3 eye, u, v, n;     ///< u right, v up, n backwards: unit vectors
    double distance;       ///< distance of the view plane
    Vec2 pixel_size;       ///< size on the view plane
    double width, height;  ///< of the image in pixels
    double lens_radius, focal;
};

/// A camera worked out for making rays.
class CameraRays {
  public:
    /// Rays of `camera`; `resolution` is width and height of the image in pixels.
    CameraRays(const Camera& camera, const Imath::V2i& resolution);

    /// Returns a ray: `pixel` in pixels from the image's top left corner (centres at .5); `lens` in
    /// [0,1)^2, of no effect on a pinhole. The direction is of unit length.
    Ray ray(const Vec2& pixel, const Vec2& lens) const;

    /// Sets `rays` to such rays, one for each of `pixels` and, where there is a lens, of `lens`.
    void rays(std::span<const Vec2> pixels, std::span<const Vec2> lens, std::span<Ray> rays) const;

    /// How far in front of the eye a point is, along the axis of view; negative behind it.
    double depth(const Vec3& point) const { return (frame_.eye - point).dot(frame_.n); }

    bool has_lens() const { return frame_.lens_radius > 0; }

    /// Matrix from world to a right-handed frame that looks down -z; row vectors, as in OpenEXR.
    Imath::M44d world_to_camera() const;

    /// Matrix from world to [-1,1]^2 over the image, x to the right, y upwards.
    Imath::M44d world_to_ndc() const;

  private:
    CameraFrame frame_;
};

}  // namespace etalon
