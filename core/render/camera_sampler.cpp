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

void CameraBatch::add(int x, int y, std::uint32_t first, std::uint32_t last) {
    const PixelSamples pixel(x, y, sampler_.seed_, sampler_.sampler_);
    for (std::uint32_t i = first; i < last; ++i) {
        pixels_.emplace_back(x, y);
        sources_.emplace_back(pixel, i);
    }
    if (!sampler_.has_samples_) return;
    const auto add_points = [&](std::uint32_t dimension, PointBatch& to) {
        const PointSet points = pixel.points(dimension);
        for (std::uint32_t i = first; i < last; ++i) to.add(points, i);
    };
    add_points(pixel_dimension, in_pixel_);
    if (sampler_.camera_.has_lens()) add_points(lens_dimension, on_lens_);
}

CameraSamples CameraBatch::make() {
    const std::span<const Vec2> in_pixel = in_pixel_.make();
    places_.clear();
    for (std::size_t i = 0; i < size(); ++i) {
        places_.push_back(Vec2(pixels_[i]) +
                          (sampler_.has_samples_ ? in_pixel[i] : sampler_.in_pixel_));
    }
    const std::vector<Vec2> middle(sampler_.has_samples_ ? 0 : size(), Vec2(0.5));
    rays_.resize(size());
    sampler_.camera_.rays(places_, sampler_.has_samples_ ? on_lens_.make() : middle, rays_);
    for (Ray& ray : rays_) ray.coherent = true;
    return {rays_, sources_};
}

void CameraBatch::clear() {
    pixels_.clear();
    sources_.clear();
    in_pixel_.clear();
    on_lens_.clear();
}

}  // namespace etalon
