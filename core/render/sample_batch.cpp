#include "core/render/sample_batch.h"

namespace etalon {

SampleBatch::SampleBatch(Film& film, const Integrator& integrator, RayCounts& counts)
    : film_(film), integrator_(integrator), counts_(counts), colors_(Integrator::batch_size) {
    samples_.reserve(Integrator::batch_size);
    pixels_.reserve(Integrator::batch_size);
}

std::uint32_t SampleBatch::room() const {
    return static_cast<std::uint32_t>(Integrator::batch_size - samples_.size());
}

void SampleBatch::add(const CameraSampler& rays, int x, int y, std::uint32_t first,
                      std::uint32_t last) {
    rays.append(x, y, first, last, samples_);
    pixels_.resize(samples_.size(), {x, y});
    if (samples_.size() == Integrator::batch_size) finish();
}

void SampleBatch::finish() {
    if (samples_.empty()) return;
    integrator_.radiance(samples_, std::span(colors_).first(samples_.size()), counts_);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        film_.add(pixels_[i].x, pixels_[i].y, colors_[i]);
    }
    done_ += samples_.size();
    samples_.clear();
    pixels_.clear();
}

}  // namespace etalon
