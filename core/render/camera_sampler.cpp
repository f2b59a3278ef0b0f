#include "core/render/camera_sampler.h"

#include "core/sampling/dimensions.h"

namespace etalon {

CameraSampler::CameraSampler(const Camera& camera, const RenderSettings& settings)
    : camera_(camera, settings.resolution),
      seed_(settings.seed),
      sampler_(settings.sampler),
      has_samples_(settings.samples_per_pixel > 0),
      shares_corners_(!has_samples_ && settings.pixel_rays == PixelRays::shared_corners),
      in_pixel_(settings.pixel_rays == PixelRays::centre ? 0.5 : 0.0) {}

Imath::Box2i CameraSampler::sampled(Imath::Box2i window) const {
    if (shares_corners_) window.max += Imath::V2i(1);
    return window;
}

void CameraSampler::append(int x, int y, std::uint32_t first, std::uint32_t last,
                           std::vector<CameraSample>& samples) const {
    const PixelSamples pixel(x, y, seed_, sampler_);
    const PointSet in_pixel = pixel.points(pixel_dimension);
    const PointSet on_lens = pixel.points(lens_dimension);
    const Vec2 corner(x, y);
    for (std::uint32_t i = first; i < last; ++i) {
        const Vec2 place = corner + (has_samples_ ? in_pixel(i) : in_pixel_);
        const Vec2 lens = has_samples_ && camera_.has_lens() ? on_lens(i) : Vec2(0.5);
        samples.push_back({camera_.ray(place, lens), {pixel, i}});
        samples.back().ray.coherent = true;
    }
}

}  // namespace etalon
