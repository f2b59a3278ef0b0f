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

/// Makes the random numbers of all samples, and their positions in their pixels.
void CameraBatch::make_samples() {
    ranges_.make_points(pixel_dimension, places_);
    if (sampler_.camera_.has_lens()) ranges_.make_points(lens_dimension, on_lens_);
    if (!sampler_.samples_time_) return;
    ranges_.make_points(time_dimension, in_time_);
    for (const Vec2& point : in_time_) times_.push_back(shutter_time(point.x));
}

/// Moves all positions to their pixels.
void CameraBatch::move_to_pixels() {
    for (const PixelRun& run : runs()) {
        const Vec2 pixel(run.pixel);
        for (std::uint32_t i = run.first; i < run.last; ++i) places_[i] += pixel;
    }
}

/// Generates the rays of all places; one by one if their times differ.
void CameraBatch::make_rays() {
    const CameraRays& camera = sampler_.camera_;
    if (camera.has_weights()) {
        weights_.resize(size());
        return camera.weighted_rays(places_, on_lens_, times_, rays_, weights_);
    }
    if (times_.empty()) return camera.rays(places_, on_lens_, rays_);
    for (std::size_t i = 0; i < size(); ++i) {
        const Vec2 lens = on_lens_.empty() ? Vec2(0.5) : on_lens_[i];
        rays_.set(i, camera.ray(places_[i], lens, times_[i]));
    }
}

CameraSamples CameraBatch::make(bool uses_sources) {
    const std::size_t count = size();
    ranges_.name();
    if (uses_sources) ranges_.list(sources_);
    times_.clear();
    if (sampler_.has_samples_) {
        make_samples();
    } else {
        places_.assign(count, sampler_.in_pixel_);
        on_lens_.assign(sampler_.camera_.has_lens() ? count : 0, Vec2(0.5));
    }
    move_to_pixels();
    rays_.make_room(count);
    make_rays();
    RayStream rays = rays_.view(count);
    rays.traits = Ray::coherent_trait;
    if (!times_.empty()) rays.times = times_.data();
    return {rays, std::span(sources_).first(uses_sources ? count : 0), weights_};
}

}  // namespace etalon
