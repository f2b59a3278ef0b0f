#include "app/render/reference.h"

#include "app/common/reference_image.h"
#include "core/image/metrics/measure_metrics.h"
#include "core/numerics/pixel_window.h"
#include "core/render/image_pixels.h"

namespace etalon {

std::string Reference::open(const std::string& path, const RenderSettings& settings) {
    Result<std::vector<Color>> image = read_reference(path, settings);
    pixels_ = std::move(image.value);
    settings_ = settings;
    width_ = window_size(settings.window()).x;
    return image.error;
}

void Reference::note(const RenderedPass& pass) {
    const Duration lap = watch_.lap();
    spent_.wall += lap.wall;
    spent_.cpu += lap.cpu;
    const std::vector<Color> pixels = image_pixels(pass.film, settings_);
    history_.push_back({{"spp", pass.samples},
                        {"seconds", spent_.wall},
                        {"cpu_seconds", spent_.cpu},
                        {"mse", mse(pixels, pixels_)},
                        {"relmse", relmse(pixels, pixels_)}});
    if (pass.expected_error) history_.back()["expected_relmse"] = *pass.expected_error;
    watch_.lap();
}

Metrics Reference::metrics_of(const Film& film) const {
    const std::vector<Color> pixels = image_pixels(film, settings_);
    const bool display_values = settings_.display_colors && settings_.keep_display_values;
    return measure(pixels, pixels_, width_, display_values).metrics;
}

}  // namespace etalon
