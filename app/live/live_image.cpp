#include "app/live/live_image.h"

#include <algorithm>
#include <numeric>

#include "core/numerics/pixel_window.h"
#include "core/parallel/parallel.h"
#include "core/render/tiles.h"

namespace etalon {
namespace {

/// Returns the number of tiles along so many pixels.
int tiles_along(int pixels) {
    return (pixels + tile_side - 1) / tile_side;
}

}  // namespace

LiveImage::LiveImage(const RenderSettings& settings)
    : settings_(settings),
      window_(settings.window()),
      width_(window_size(window_).x),
      tiles_across_(tiles_along(width_)),
      tiles_(tiles_of(window_)),
      versions_(tiles_.size()),
      mutexes_(tiles_along(window_size(window_).y)) {
    const std::size_t size = pixel_count(window_);
    pixels_ = {std::vector<Color>(size, Color(0.0F)), std::vector<std::uint32_t>(size, 0),
               std::vector<float>(size, 0.0F)};
}

RenderObserver LiveImage::observer() {
    return {.after_tile = [this](const RenderedTile& tile) { put_tile(tile); },
            .after_pass = [this](const RenderedPass& pass) { put_film(pass.film); }};
}

std::size_t LiveImage::tile_at(int x, int y) const {
    return static_cast<std::size_t>((y - window_.min.y) / tile_side) * tiles_across_ +
           (x - window_.min.x) / tile_side;
}

std::mutex& LiveImage::mutex_of(int y) const {
    return mutexes_[static_cast<std::size_t>((y - window_.min.y) / tile_side)];
}

std::uint64_t LiveImage::version() const {
    return std::accumulate(versions_.begin(), versions_.end(), std::uint64_t{0});
}

void LiveImage::put_tile(const RenderedTile& rendered) {
    const Imath::Box2i part = common_window(rendered.tile, window_);
    if (part.isEmpty()) return;
    const auto seconds =
        static_cast<float>(rendered.seconds / static_cast<double>(pixel_count(rendered.tile)));
    for (int y = part.min.y; y <= part.max.y; ++y) {
        const std::lock_guard lock(mutex_of(y));
        put_row(rendered.samples, y, part.min.x, part.max.x);
        for (int x = part.min.x; x <= part.max.x; ++x) pixels_.seconds[index(x, y)] += seconds;
    }
}

void LiveImage::put_film(const Film& film) {
    parallel_for(mutexes_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const std::lock_guard lock(mutexes_[row]);
            const int top = window_.min.y + static_cast<int>(row) * tile_side;
            const int bottom = std::min(top + tile_side - 1, window_.max.y);
            for (int y = top; y <= bottom; ++y) put_row(film, y, window_.min.x, window_.max.x);
        }
    });
}

/// The row's mutex must be held.
void LiveImage::put_row(const Film& film, int y, int first, int last) {
    for (int x = first; x <= last; ++x) {
        const std::size_t to = index(x, y), from = film.index(x, y);
        const Color color(film.mean(from));
        const std::uint32_t samples = film.counts()[from];
        if (color == pixels_.colors[to] && samples == pixels_.samples[to]) continue;
        pixels_.colors[to] = color;
        pixels_.samples[to] = samples;
        ++versions_[tile_at(x, y)];
    }
}

void LiveImage::copy(const Imath::Box2i& part, Pixels& to) const {
    const std::lock_guard lock(mutex_of(part.min.y));
    for (int y = part.min.y; y <= part.max.y; ++y) {
        const std::size_t first = index(part.min.x, y), last = index(part.max.x, y) + 1;
        const auto append = [&](const auto& from, auto& values) {
            values.insert(values.end(), from.begin() + first, from.begin() + last);
        };
        append(pixels_.colors, to.colors);
        append(pixels_.samples, to.samples);
        append(pixels_.seconds, to.seconds);
    }
}

LiveImage::Pixels LiveImage::pixels_of(std::size_t tile) const {
    Pixels result;
    copy(tiles_[tile], result);
    return result;
}

LiveImage::Summary LiveImage::summary() const {
    Summary sum;
    const auto width = static_cast<std::size_t>(width_);
    for (int y = window_.min.y; y <= window_.max.y; ++y) {
        const std::lock_guard lock(mutex_of(y));
        for (std::size_t i = index(window_.min.x, y), end = i + width; i < end; ++i) {
            sum.samples += pixels_.samples[i];
            sum.most_samples = std::max(sum.most_samples, pixels_.samples[i]);
            sum.most_seconds = std::max(sum.most_seconds, pixels_.seconds[i]);
        }
    }
    sum.samples /= static_cast<double>(pixels_.samples.size());
    return sum;
}

LiveImage::Pixels LiveImage::pixels() const {
    Pixels result;
    for (int y = window_.min.y; y <= window_.max.y; y += tile_side) {
        const int bottom = std::min(y + tile_side - 1, window_.max.y);
        copy({{window_.min.x, y}, {window_.max.x, bottom}}, result);
    }
    return result;
}

}  // namespace etalon
