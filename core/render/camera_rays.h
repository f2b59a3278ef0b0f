#pragma once

#include <memory>
#include <span>

#include "core/camera/lens_rays.h"
#include "core/intersect/ray_stream.h"
#include "core/render/camera_frame.h"

namespace etalon {

/// A camera prepared to generate rays.
class CameraRays {
  public:
    /// Prepares `camera`; `resolution` is the width and height of the image in pixels.
    CameraRays(const Camera& camera, const Imath::V2i& resolution);

    /// Returns a camera ray. `pixel` is in pixels from the image's top left corner (centres at .5);
    /// `lens`, in [0,1)^2, has no effect on a pinhole; `time` is when the ray sees the scene. The
    /// direction is of unit length.
    Ray ray(const Vec2& pixel, const Vec2& lens, ShutterTime time = 0) const;

    /// Sets the first rays of a buffer, which must be large enough, to the camera rays of `pixels`
    /// and, if there is a lens, of `lens`, at the time at which the shutter opens.
    void rays(std::span<const Vec2> pixels, std::span<const Vec2> lens, RayBuffer& rays) const;

    /// Returns whether rays have different weights: if a lens of several surfaces blocks some.
    bool has_weights() const { return lens_ != nullptr; }

    /// Sets `weights`, too, to the weights of the rays, for a camera that has_weights(). `times`
    /// are those of the rays; if empty, all rays have the time at which the shutter opens.
    void weighted_rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                       std::span<const ShutterTime> times, RayBuffer& rays,
                       std::span<float> weights) const;

    /// Returns how far a point is in front of the eye, along the axis of view; negative behind it.
    /// For an environment camera, returns the distance. For a moving camera the eye, and the
    /// matrices too, are those of the time at which the shutter opens.
    double depth(const Vec3& point) const {
        const Vec3 back = frame_.eye - point;
        return frame_.projection == Projection::environment ? back.length() : back.dot(frame_.n);
    }

    bool has_lens() const { return lens_ != nullptr || frame_.lens_radius > 0; }

    /// Returns the matrix from world space to a frame with x to the right and y up that looks down
    /// -z, right-handed unless the camera shows a mirrored image; for row vectors, as in OpenEXR.
    const Imath::M44d& world_to_camera() const { return frame_.world_to_camera; }

    /// Returns the matrix from world space to [-1,1]^2 over the image, x to the right, y upwards;
    /// none for an environment camera and a lens of several surfaces.
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
    std::shared_ptr<const LensRays> lens_;  ///< if it has several surfaces; else null
};

}  // namespace etalon
