#include "core/render/film.h"

#include <algorithm>
#include <numeric>

#include "core/numerics/exact.h"
#include "core/numerics/pixel_window.h"
#include "core/parallel/parallel.h"

namespace etalon {

Film::Film(const Imath::Box2i& window, bool with_squares)
    : window_(window),
      width_(window_size(window).x),
      sums_(pixel_count(window), Vec3(0)),
      squares_(with_squares ? sums_.size() : 0, Vec3(0)),
      counts_(sums_.size(), 0) {}

void Film::add(int x, int y, const Color& sample) {
    const std::size_t i = index(x, y);
    const Vec3 value(sample);
    sums_[i] += value;
    if (!squares_.empty()) squares_[i] += value * value;
    ++counts_[i];
}

void Film::add(std::span<const PixelRun> runs, std::span<const Color> samples) {
    for (const PixelRun& run : runs) {
        const std::size_t pixel = index(run.pixel.x, run.pixel.y);
        Vec3 sum = sums_[pixel];
        for (std::uint32_t i = run.first; i < run.last; ++i) sum += Vec3(samples[i]);
        sums_[pixel] = sum;
        counts_[pixel] += run.size();
        if (squares_.empty()) continue;
        for (std::uint32_t i = run.first; i < run.last; ++i) {
            squares_[pixel] += Vec3(samples[i]) * Vec3(samples[i]);
        }
    }
}

void Film::add(const Film& other) {
    errors_.resize(size(), Vec3(0));
    parallel_for(size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int k = 0; k < 3; ++k) {
                const TwoTerm sum = two_sum(sums_[i][k], other.sums_[i][k]);
                sums_[i][k] = sum.value;
                errors_[i][k] += sum.error;
            }
            if (!other.errors_.empty()) errors_[i] += other.errors_[i];
            counts_[i] += other.counts_[i];
        }
    });
}

std::uint64_t Film::total_count() const {
    return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

std::vector<Color> Film::pixels() const {
    std::vector<Color> result;
    result.reserve(size());
    prefer_large_pages(result.data(), size() * sizeof(Color));
    result.resize(size());
    parallel_for(size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = Color(mean(i));
    });
    return result;
}

std::vector<Color> Film::variances() const {
    std::vector<Color> result(size(), Color(0.0F));
    for (std::size_t i = 0; i < size(); ++i) {
        if (counts_[i] < 2) continue;
        const Vec3 about_mean = squares_[i] - sample_mean(i) * sums_[i];
        for (int k = 0; k < 3; ++k) {  // rounding may make it negative
            result[i][k] = static_cast<float>(std::max(0.0, about_mean[k]) / (counts_[i] - 1.0));
        }
    }
    return result;
}

void Film::add_all(std::size_t pixel, const Film& from, std::size_t pixel_of_it) {
    sums_[pixel] += from.sums_[pixel_of_it];
    counts_[pixel] += from.counts_[pixel_of_it];
    if (!squares_.empty()) squares_[pixel] += from.squares_[pixel_of_it];
}

Film Film::filtered(const Imath::Box2i& window, std::vector<Vec3> means) const {
    Film result(window, !squares_.empty());
    for (int y = window.min.y; y <= window.max.y; ++y) {
        for (int x = window.min.x; x <= window.max.x; ++x) {
            result.add_all(result.index(x, y), *this, index(x, y));
        }
    }
    result.filtered_means_ = std::move(means);
    return result;
}

Film Film::cells() const {
    Film result({window_.min, window_.max - Imath::V2i(1)}, !squares_.empty());
    for (int y = window_.min.y; y < window_.max.y; ++y) {
        for (int x = window_.min.x; x < window_.max.x; ++x) {
            for (const auto& [dx, dy] : {Imath::V2i(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                result.add_all(result.index(x, y), *this, index(x + dx, y + dy));
            }
        }
    }
    return result;
}

}  // namespace etalon
