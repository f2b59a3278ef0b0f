#include "app/render/reference.h"

#include <fmt/format.h>

#include "core/image/io.h"
#include "core/image/metrics/flip.h"
#include "core/image/metrics/measure.h"

namespace etalon {
namespace {

Imath::V2i size_of(const Imath::Box2i& window) {
    return window.size() + Imath::V2i(1);
}

/// Rows of `pixels`, `width` wide, that lie in the window.
std::vector<Color> cut_out(const std::vector<Color>& pixels, int width,
                           const Imath::Box2i& window) {
    std::vector<Color> part;
    for (int y = window.min.y; y <= window.max.y; ++y) {
        const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(y) * width;
        part.insert(part.end(), row + window.min.x, row + window.max.x + 1);
    }
    return part;
}

}  // namespace

std::string Reference::open(const std::string& path, const Camera& camera,
                            const Imath::Box2i& window, bool display_colors) {
    Outcome<Image> file = read_image(path);
    if (!file) return file.error;
    // A PNG does not say which values it has: those of the picture it was made from.
    if (display_colors && file.value.encoding == Encoding::srgb) {
        file.value.encoding = Encoding::display;
    }
    const Imath::V2i size(file.value.width, file.value.height), frame(camera.width, camera.height);
    if (size != frame && size != size_of(window)) {
        return fmt::format("{}: {} x {} pixels; expected {} x {}", path, size.x, size.y,
                           size_of(window).x, size_of(window).y);
    }
    pixels_ = linear_pixels(file.value);
    if (size == frame) pixels_ = cut_out(pixels_, size.x, window);
    width_ = size_of(window).x;
    watch_.lap();
    return {};
}

void Reference::note(const RenderedRound& round) {
    const Duration lap = watch_.lap();
    spent_.wall += lap.wall;
    spent_.cpu += lap.cpu;
    const std::vector<Color> pixels = round.film.pixels();
    const auto samples = static_cast<double>(round.film.total_count());
    history_.push_back({{"spp", samples / static_cast<double>(round.film.size())},
                        {"seconds", spent_.wall},
                        {"cpu_seconds", spent_.cpu},
                        {"mse", mse(pixels, pixels_)},
                        {"relmse", relmse(pixels, pixels_)}});
    if (round.expected_error > 0) history_.back()["expected_relmse"] = round.expected_error;
    watch_.lap();
}

Metrics Reference::judge(const Film& film) const {
    const std::vector<Color> pixels = film.pixels();
    return measure(pixels, pixels_, flip_map(pixels, pixels_, width_));
}

}  // namespace etalon
