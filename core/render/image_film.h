#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/render/film.h"
#include "core/render/splat_film.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// The film of an image with its settings: the scaling of samples, and the pixels for which they
/// count. Threads may add samples to different tiles at the same time.
class ImageFilm {
  public:
    /// Makes a film for an image of `window` with the filter of the settings.
    ImageFilm(const Imath::Box2i& window, const RenderSettings& settings);

    /// Adds the samples of several pixels, each at its place, in pixels. Sets `colors` to what was
    /// added. A sample that is not finite counts as black, as in pbrt-v3; returns the number of
    /// these. For `weights` see CameraSamples.
    std::size_t add(std::span<const PixelRun> runs, std::span<const Vec2> places,
                    std::span<Color> colors, std::span<const float> weights = {});

    /// Adds the samples of another film of the same window and filter, in any order of films.
    void add(const ImageFilm& other);

    /// Sets how many of each pixel's samples count as one. To be called before any sample is added.
    void set_rates(SampleRates rates) { rates_ = std::move(rates); }
    const SampleRates& rates() const { return rates_; }

    /// Returns the samples of each pixel. With a filter wider than a pixel there are some beyond
    /// the image's window.
    const Film& samples() const { return samples_; }

    /// Returns the tiles to which threads may add samples at the same time.
    std::vector<Imath::Box2i> tiles() const;

    bool is_filtered() const { return splats_.has_value(); }

    /// Returns the filtered image.
    Film filtered() const {
        return samples_.filtered(window_, splats_->means(window_, samples_, rates_));
    }

    /// Returns the samples of an image that is not filtered, by moving them.
    Film take_samples() { return std::move(samples_); }

    template <class Bytes>
    void transfer(Bytes& bytes) {
        samples_.transfer(bytes);
        bytes(rates_);
        bytes.expect(rates_.empty() || rates_.size() == samples_.size());
        bytes.expect(std::ranges::count(rates_, 0) == 0);
        if (splats_) splats_->transfer(bytes);
    }

    /// Transfers only one of the tiles, of a film to which no other was added.
    template <class Bytes>
    void transfer(Bytes& bytes, const Imath::Box2i& tile) {
        samples_.transfer(bytes, tile);
        if (splats_) splats_->transfer(bytes, tile);
    }

    /// Returns the bytes of memory for each pixel.
    static double bytes_per_pixel(const RenderSettings& settings);

    /// Returns a number of bytes that transfer() writes at least of a film with these arguments;
    /// the memory that such a film takes at first does not exceed it by much.
    static std::uint64_t least_bytes(const Imath::Box2i& window, const RenderSettings& settings);

  private:
    /// Converts a colour to what is added to the film. Returns whether it was finite.
    bool prepare(Color& sample) const;

    /// Converts many. Returns how many were not finite.
    std::size_t prepare(std::span<Color> samples) const;

    Imath::Box2i window_;
    Film samples_;
    SampleRates rates_;
    std::optional<SplatFilm> splats_;
    float scale_, max_luminance_;
    bool changes_samples_;
};

}  // namespace etalon
