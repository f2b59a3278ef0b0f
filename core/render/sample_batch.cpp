#include "core/render/sample_batch.h"

namespace etalon {

SampleBatch::SampleBatch(const CameraSampler& camera, const Integrator& integrator, ImageFilm& film,
                         RayCounts& counts)
    : samples_(camera),
      integrator_(integrator),
      film_(film),
      counts_(counts),
      colors_(Integrator::batch_size) {}

std::uint32_t SampleBatch::room() const {
    return static_cast<std::uint32_t>(Integrator::batch_size - samples_.size());
}

void SampleBatch::add(int x, int y, std::uint32_t first, std::uint32_t last) {
    samples_.add(x, y, first, last);
    if (samples_.size() == Integrator::batch_size) finish();
}

void SampleBatch::finish() {
    const std::size_t count = samples_.size();
    if (count == 0) return;
    const std::span colors = std::span(colors_).first(count);
    integrator_.radiance(samples_.make(), colors, counts_);
    dropped_ += film_.add(samples_.pixels(), samples_.places(), colors);
    done_ += count;
    samples_.clear();
}

}  // namespace etalon
