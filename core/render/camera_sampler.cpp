#include "core/render/camera_sampler.h"

#include "core/sampling/dimensions.h"

namespace etalon {

CameraSampler::CameraSampler(const Camera& camera, const RenderSettings& settings)
    : camera_(camera, settings.resolution),
      seed_(settings.seed),
      sampler_(settings.sampler),
      has_samples_(settings.samples_per_pixel > 0),
      shares_corners_(!has_samples_ && settings.pixel_rays == PixelRays::shared_corners),
      samples_time_(has_samples_ && camera.sees_motion),
      in_pixel_(settings.pixel_rays == PixelRays::centre ? 0.5 : 0.0) {}

Imath::Box2i CameraSampler::sampled(Imath::Box2i window) const {
    if (shares_corners_) window.max += Imath::V2i(1);
    return window;
}

void CameraBatch::add(int x, int y, std::uint32_t first, std::uint32_t last) {
    const PixelSamples pixel(x, y, sampler_.seed_, sampler_.sampler_);
    pixels_.resize(size() + (last - first), {x, y});
    for (std::uint32_t i = first; i < last; ++i) sources_.emplace_back(pixel, i);
    if (!sampler_.has_samples_) return;
    in_pixel_.add(pixel.points(pixel_dimension), first, last);
    if (sampler_.camera_.has_lens()) on_lens_.add(pixel.points(lens_dimension), first, last);
    if (sampler_.samples_time_) in_time_.add(pixel.points(time_dimension), first, last);
}

void CameraBatch::make_samples() {
    const std::span<const Vec2> in_pixel = in_pixel_.make();
    for (std::size_t i = 0; i < size(); ++i) places_[i] = Vec2(pixels_[i]) + in_pixel[i];
    times_.clear();
    if (sampler_.samples_time_) {
        for (const Vec2& point : in_time_.make()) times_.push_back(shutter_time(point.x));
    }
    make_rays(on_lens_.make());
}

/// Generates the rays of all places; one by one if their times differ.
void CameraBatch::make_rays(std::span<const Vec2> on_lens) {
    const CameraRays& camera = sampler_.camera_;
    if (camera.has_weights()) {
        weights_.resize(size());
        return camera.weighted_rays(places_, on_lens, times_, rays_, weights_);
    }
    if (times_.empty()) return camera.rays(places_, on_lens, rays_);
    for (std::size_t i = 0; i < size(); ++i) {
        const Vec2 lens = on_lens.empty() ? Vec2(0.5) : on_lens[i];
        rays_.set(i, camera.ray(places_[i], lens, times_[i]));
    }
}

CameraSamples CameraBatch::make() {
    const std::size_t count = size();
    places_.resize(count);
    rays_.make_room(count);
    if (sampler_.has_samples_) {
        make_samples();
    } else {
        for (std::size_t i = 0; i < count; ++i) places_[i] = Vec2(pixels_[i]) + sampler_.in_pixel_;
        const std::vector<Vec2> middle(sampler_.camera_.has_lens() ? count : 0, Vec2(0.5));
        make_rays(middle);
    }
    RayStream rays = rays_.view(count);
    rays.traits = Ray::coherent_trait;
    if (!times_.empty()) rays.times = times_.data();
    return {rays, sources_, weights_};
}

void CameraBatch::clear() {
    pixels_.clear();
    sources_.clear();
    in_pixel_.clear();
    on_lens_.clear();
    in_time_.clear();
}

}  // namespace etalon
