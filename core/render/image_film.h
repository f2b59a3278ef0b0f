#pragma once

#include <optional>
#include <vector>

#include "core/render/film.h"
#include "core/render/splat_film.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// The film of an image by its settings: what samples are multiplied by, and which pixels they
/// count for. Threads may add samples to different tiles at the same time.
class ImageFilm {
  public:
    /// Film for an image of `window` whose filter is that of the settings.
    ImageFilm(const Imath::Box2i& window, const RenderSettings& settings);

    /// Adds samples, each at its place, in pixels, of the pixel in which it lies; `colors` becomes
    /// what was added. One that is infinite or no number counts as black, as in pbrt-v3. Returns
    /// how many were of that kind. `weights`: see CameraSamples.
    std::size_t add(std::span<const Imath::V2i> pixels, std::span<const Vec2> places,
                    std::span<Color> colors, std::span<const float> weights = {});

    /// Adds the samples of another film of the same window and filter, in any order of films.
    void add(const ImageFilm& other);

    /// Says how many of each pixel's samples count as one, before any is added.
    void set_rates(SampleRates rates) { rates_ = std::move(rates); }
    const SampleRates& rates() const { return rates_; }

    /// The samples of each pixel. Where a filter is wider than a pixel, there are some beyond the
    /// image's window.
    const Film& samples() const { return samples_; }

    /// The tiles that threads may add samples to at the same time.
    std::vector<Imath::Box2i> tiles() const;

    bool is_filtered() const { return splats_.has_value(); }

    /// The image that the filter makes of them.
    Film filtered() const {
        return samples_.filtered(window_, splats_->means(window_, samples_, rates_));
    }

    /// Takes the samples of an image that is not filtered.
    Film take_samples() { return std::move(samples_); }

    template <class Bytes>
    void transfer(Bytes& bytes) {
        samples_.transfer(bytes);
        bytes(rates_);
        bytes.expect(rates_.empty() || rates_.size() == samples_.size());
        if (splats_) splats_->transfer(bytes);
    }

    /// The same of one of the tiles, of a film to which no other was added.
    template <class Bytes>
    void transfer(Bytes& bytes, const Imath::Box2i& tile) {
        samples_.transfer(bytes, tile);
        if (splats_) splats_->transfer(bytes, tile);
    }

    /// Bytes of memory for each pixel.
    static double bytes_per_pixel(const RenderSettings& settings);

  private:
    /// Scales, limits and replaces a colour as the film takes it. Returns whether it was finite.
    bool prepare(Color& sample) const;

    /// The same for many. Returns how many were not finite.
    std::size_t prepare(std::span<Color> samples) const;

    Imath::Box2i window_;
    Film samples_;
    SampleRates rates_;
    std::optional<SplatFilm> splats_;
    float scale_, max_luminance_;
    bool changes_samples_;
};

}  // namespace etalon
