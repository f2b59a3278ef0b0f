#include "core/render/eye_rays.h"

namespace etalon {
namespace {

/// Names of the camera's sample dimensions; the integrator's are hashes.
enum CameraDimension : std::uint32_t { pixel_dimension = 0, lens_dimension = 1 };

}  // namespace

EyeRays::EyeRays(const Camera& camera, int samples_per_pixel)
    : camera_(camera),
      has_samples_(samples_per_pixel > 0),
      shares_corners_(!has_samples_ && camera.pixel_rays == PixelRays::shared_corners),
      in_pixel_(camera.pixel_rays == PixelRays::centre ? 0.5 : 0.0) {}

Imath::Box2i EyeRays::sampled(Imath::Box2i window) const {
    if (shares_corners_) window.max += Imath::V2i(1);
    return window;
}

Ray EyeRays::ray(int x, int y, const SampleSource& sample) const {
    const Vec2 corner(x, y);
    if (!has_samples_) return camera_.ray(corner + in_pixel_, Vec2(0.5));
    const Vec2 lens = camera_.has_lens() ? sample.point(lens_dimension) : Vec2(0.5);
    return camera_.ray(corner + sample.point(pixel_dimension), lens);
}

}  // namespace etalon
