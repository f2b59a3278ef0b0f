#include "core/render/image_film.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/numerics/luminance.h"
#include "core/numerics/pixel_window.h"
#include "core/render/tiles.h"

namespace etalon {
namespace {

Film sample_film(const Imath::Box2i& window, const RenderSettings& settings) {
    return Film(sampled_window(window, settings.filter), settings.variance);
}

/// Returns the side of the cells of pixels that always have the same number of samples.
int cell_side(const RenderSettings& settings) {
    return settings.target_error > 0 ? 1 : tile_side;
}

/// Returns whether all components are finite. Compares bits as integers, which the compiler
/// vectorizes: adding 1 to an exponent carries into the sign where all of its bits are set.
bool are_finite(std::span<const Color> colors) {
    constexpr std::uint32_t magnitude = 0x7fffffff, lowest_of_exponent = 0x00800000;
    static_assert(sizeof(Color) == 3 * sizeof(float));
    std::uint32_t carries = 0;
    for (const float& x : std::span(colors.empty() ? nullptr : &colors[0].x, 3 * colors.size())) {
        carries |= (std::bit_cast<std::uint32_t>(x) & magnitude) + lowest_of_exponent;
    }
    return carries <= magnitude;
}

}  // namespace

ImageFilm::ImageFilm(const Imath::Box2i& window, const RenderSettings& settings)
    : window_(window),
      samples_(sample_film(window, settings)),
      scale_(static_cast<float>(settings.film_scale)),
      max_luminance_(static_cast<float>(settings.max_sample_luminance)),
      changes_samples_(settings.film_scale != 1 || settings.max_sample_luminance < infinity) {
    if (!settings.filter.is_pixel_box()) {
        splats_.emplace(samples_.window(), cell_side(settings), settings.filter);
    }
}

bool ImageFilm::prepare(Color& sample) const {
    if (changes_samples_) {
        const float y = luminance(sample);
        sample *= y > max_luminance_ ? scale_ * (max_luminance_ / y) : scale_;
    }
    if (is_finite(sample)) return true;
    sample = Color(0.0F);
    return false;
}

std::size_t ImageFilm::prepare(std::span<Color> samples) const {
    if (!changes_samples_ && are_finite(samples)) return 0;
    std::size_t dropped = 0;
    for (Color& sample : samples) dropped += prepare(sample) ? 0 : 1;
    return dropped;
}

std::size_t ImageFilm::add(std::span<const PixelRun> runs, std::span<const Vec2> places,
                           std::span<Color> colors, std::span<const float> weights) {
    const std::size_t dropped = prepare(colors);
    for (std::size_t i = 0; i < weights.size(); ++i) colors[i] *= weights[i];
    samples_.add(runs, colors);
    if (!splats_) return dropped;
    for (const PixelRun& run : runs) {
        const std::size_t pixel = samples_.index(run.pixel.x, run.pixel.y);
        const double weight = rates_.empty() ? 1 : 1.0 / rates_[pixel];
        for (std::uint32_t i = run.first; i < run.last; ++i) {
            splats_->add(run.pixel, places[i], colors[i], weight);
        }
    }
    return dropped;
}

void ImageFilm::add(const ImageFilm& other) {
    samples_.add(other.samples_);
    if (splats_) splats_->add(*other.splats_, other.splats_->counts(other.samples_, other.rates_));
}

std::vector<Imath::Box2i> ImageFilm::tiles() const {
    const Imath::Box2i& window = samples_.window();
    return splats_ ? tiles_of(window, splats_->corner()) : tiles_of(window);
}

double ImageFilm::bytes_per_pixel(const RenderSettings& settings) {
    const double own = sizeof(Vec3) + sizeof(std::uint32_t);
    if (settings.filter.is_pixel_box()) return own;
    return 2 * own + sizeof(Vec3) +
           SplatFilm::bytes_per_pixel(cell_side(settings), settings.filter);
}

std::uint64_t ImageFilm::least_bytes(const Imath::Box2i& window, const RenderSettings& settings) {
    const Imath::Box2i sampled = sampled_window(window, settings.filter);
    const std::uint64_t own = pixel_count(sampled) * (sizeof(Vec3) + sizeof(std::uint32_t));
    if (settings.filter.is_pixel_box()) return own;
    return own + SplatFilm::bytes_of(sampled, cell_side(settings), settings.filter);
}

}  // namespace etalon
