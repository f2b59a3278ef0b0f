#include "core/render/camera_sampler.h"

#include "core/sampling/dimensions.h"

namespace etalon {

CameraSampler::CameraSampler(const Camera& camera, const RenderSettings& settings)
    : camera_(camera, settings.resolution),
      has_samples_(settings.samples_per_pixel > 0),
      shares_corners_(!has_samples_ && settings.pixel_rays == PixelRays::shared_corners),
      in_pixel_(settings.pixel_rays == PixelRays::centre ? 0.5 : 0.0) {}

Imath::Box2i CameraSampler::sampled(Imath::Box2i window) const {
    if (shares_corners_) window.max += Imath::V2i(1);
    return window;
}

Ray CameraSampler::ray(int x, int y, const SampleSource& sample) const {
    Vec2 pixel = Vec2(x, y) + in_pixel_, lens(0.5);
    if (has_samples_) {
        pixel = Vec2(x, y) + sample.point(pixel_dimension);
        if (camera_.has_lens()) lens = sample.point(lens_dimension);
    }
    Ray ray = camera_.ray(pixel, lens);
    ray.coherent = true;
    return ray;
}

}  // namespace etalon
