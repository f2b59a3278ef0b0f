#include "core/render/tile_renderer.h"

#include <algorithm>

#include "core/base/clocks.h"

namespace etalon {

TileRenderer::TileRenderer(const Camera& camera, const Integrator& integrator,
                           const RenderSettings& settings)
    : first_sample_(settings.sample_range().first),
      integrator_(integrator),
      rays_(camera, settings),
      film_(rays_.sampled(settings.window()), settings),
      tiles_(film_.tiles()) {
    if (settings.target_error > 0) return;
    film_.set_rates(sample_rates(camera, integrator, settings, film_.samples().window()));
}

Film TileRenderer::take_image() {
    if (film_.is_filtered()) return film_.filtered();
    return rays_.shares_corners() ? film_.samples().cells() : film_.take_samples();
}

std::vector<std::size_t> TileRenderer::unfinished_tiles() const {
    std::vector<std::size_t> unfinished;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
        bool lacks_samples = false;
        for_each_pixel(tiles_[tile], [&](int x, int y) {
            const std::size_t pixel = film_.samples().index(x, y);
            lacks_samples |= film_.samples().counts()[pixel] < goal.of(pixel);
        });
        if (lacks_samples) unfinished.push_back(tile);
    }
    return unfinished;
}

/// Returns the number of the pixel's first sample in this part of the image.
inline std::uint32_t TileRenderer::first_sample(std::size_t pixel) const {
    const SampleRates& rates = film_.rates();
    return first_sample_ * (rates.empty() ? 1U : rates[pixel]);
}

/// Adds the samples that the pixel lacks to the batch. Returns false if interrupted(), which is
/// asked whenever the batch was rendered.
inline bool TileRenderer::add_pixel(int x, int y, const std::function<bool()>& interrupted,
                                    SampleBatch& batch) const {
    const std::size_t pixel = film_.samples().index(x, y);
    const std::uint32_t first = first_sample(pixel);
    std::uint32_t next = first + film_.samples().counts()[pixel];
    for (const std::uint32_t last = first + goal.of(pixel); next < last;) {
        const std::uint32_t end = std::min(last, next + batch.room());
        if (batch.add(x, y, next, end) && interrupted()) return false;
        next = end;
    }
    return true;
}

TileResult TileRenderer::render(std::size_t tile, const std::function<bool()>& interrupted) {
    const auto seconds = [&] { return measures_seconds ? thread_cpu_seconds() : 0.0; };
    const double start = seconds();
    TileResult result;
    const auto loan = batches_.lend(rays_, integrator_, film_);
    SampleBatch& batch = *loan;
    batch.begin(result.counts);
    bool is_over = false;
    for_each_pixel(
        tiles_[tile], [&] { return is_over; },
        [&](int x, int y) {
            if (!is_over) is_over = !add_pixel(x, y, interrupted, batch);
        });
    batch.finish();
    result.samples = batch.done();
    result.dropped = batch.dropped();
    result.seconds = seconds() - start;
    return result;
}

}  // namespace etalon
