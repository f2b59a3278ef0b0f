#include "core/render/sample_batch.h"

namespace etalon {

SampleBatch::SampleBatch(const CameraSampler& camera, const Integrator& integrator, ImageFilm& film)
    : samples_(camera), integrator_(integrator), film_(film), colors_(Integrator::batch_size) {}

void SampleBatch::begin(RayCounts& counts) {
    samples_.clear();
    counts_ = &counts;
    done_ = dropped_ = 0;
}

void SampleBatch::finish() {
    const std::size_t count = samples_.size();
    if (count == 0) return;
    const std::span colors = std::span(colors_).first(count);
    const CameraSamples samples = samples_.make(integrator_.uses_sources());
    if (samples.weights.empty()) {
        integrator_.radiance(samples, colors, *counts_);
    } else {
        render_weighted(samples, colors);
    }
    dropped_ += film_.add(samples_.runs(), samples_.places(), colors, samples.weights);
    done_ += count;
    samples_.clear();
}

/// Renders the samples with a weight above 0; the others are black.
void SampleBatch::render_weighted(const CameraSamples& samples, std::span<Color> colors) {
    weighted_sources_.clear();
    weighted_times_.clear();
    weighted_rays_.make_room(colors.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (samples.weights[i] == 0) continue;
        weighted_rays_.set(count++, samples.rays[i]);
        if (!samples.sources.empty()) weighted_sources_.push_back(samples.sources[i]);
        if (samples.rays.times != nullptr) weighted_times_.push_back(samples.rays.times[i]);
    }
    RayStream rays = weighted_rays_.view(count);
    rays.traits = samples.rays.traits;
    if (samples.rays.times != nullptr) rays.times = weighted_times_.data();
    weighted_colors_.resize(rays.size());
    if (!rays.empty()) {
        integrator_.radiance({rays, weighted_sources_}, weighted_colors_, *counts_);
    }
    auto next = weighted_colors_.begin();
    for (std::size_t i = 0; i < colors.size(); ++i) {
        colors[i] = samples.weights[i] == 0 ? Color(0.0F) : *next++;
    }
}

}  // namespace etalon
