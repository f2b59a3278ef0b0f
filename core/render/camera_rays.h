#pragma once

#include <memory>
#include <span>

#include "core/camera/lens_rays.h"
#include "core/intersect/ray_stream.h"
#include "core/render/camera_frame.h"

namespace etalon {

/// A camera worked out for making rays.
class CameraRays {
  public:
    /// Rays of `camera`; `resolution` is width and height of the image in pixels.
    CameraRays(const Camera& camera, const Imath::V2i& resolution);

    /// Returns a ray: `pixel` in pixels from the image's top left corner (centres at .5); `lens` in
    /// [0,1)^2, of no effect on a pinhole; the time at which it sees the scene. The direction is of
    /// unit length.
    Ray ray(const Vec2& pixel, const Vec2& lens, ShutterTime time = 0) const;

    /// Sets the first rays of a buffer, which has room for them, to such rays, one for each of
    /// `pixels` and, where there is a lens, of `lens`, of the time at which the shutter opens.
    void rays(std::span<const Vec2> pixels, std::span<const Vec2> lens, RayBuffer& rays) const;

    /// Returns whether rays count differently: where a lens of several surfaces stops some.
    bool has_weights() const { return lens_ != nullptr; }

    /// Sets `weights`, too, to what the rays' light counts. For a camera that has weights. `times`
    /// are those of the rays, or none: that at which the shutter opens.
    void weighted_rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                       std::span<const ShutterTime> times, RayBuffer& rays,
                       std::span<float> weights) const;

    /// How far in front of the eye a point is, along the axis of view; negative behind it. For an
    /// environment: how far away. The eye, and matrices too, of a camera that moves are those of
    /// the time at which the shutter opens.
    double depth(const Vec3& point) const {
        const Vec3 back = frame_.eye - point;
        return frame_.projection == Projection::environment ? back.length() : back.dot(frame_.n);
    }

    bool has_lens() const { return lens_ != nullptr || frame_.lens_radius > 0; }

    /// Matrix from world to a frame with x to the right and y up that looks down -z, right-handed
    /// unless the camera shows what a mirror would; row vectors, as in OpenEXR.
    const Imath::M44d& world_to_camera() const { return frame_.world_to_camera; }

    /// Matrix from world to [-1,1]^2 over the image, x to the right, y upwards; none for an
    /// environment and a lens of several surfaces.
    const std::optional<Imath::M44d>& world_to_ndc() const { return frame_.world_to_ndc; }

  private:
    struct WeightedRay {
        Vec3 origin, direction;
        float weight;
    };

    CameraFrame frame_at(ShutterTime time) const;
    WeightedRay weighted_ray(const Vec2& pixel, const Vec2& lens, ShutterTime time) const;

    CameraFrame frame_;
    std::optional<AnimatedTransform> motion_;
    std::shared_ptr<const LensRays> lens_;  ///< of several surfaces; else null
};

}  // namespace etalon
