#include "core/render/splat_film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numerics/exact.h"
#include "core/numerics/pixel_window.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

int divided_up(int a, int b) {
    return (a + b - 1) / b;
}

/// Returns the largest multiple of `side` that is at most `place`.
int aligned(int place, int side) {
    const int beyond = place % side;
    return place - (beyond < 0 ? beyond + side : beyond);
}

Imath::V2i pixels_before(const FilterAxis& across, const FilterAxis& down) {
    return {-across.first(0), -down.first(0)};
}

Imath::V2i block_size(int side, const FilterAxis& across, const FilterAxis& down) {
    return pixels_before(across, down) + Imath::V2i(across.last(side), down.last(side)) +
           Imath::V2i(1);
}

/// Weights of one sample for consecutive pixels along one axis.
struct Weights {
    int first, count;
    std::array<double, WeightedSample::most_pixels> values;

    Weights(const FilterAxis& axis, double place)
        : first(axis.first(place)), count(axis.last(place) - first + 1) {
        for (int i = 0; i < count; ++i) values[i] = axis(place - 0.5 - (first + i));
    }
};

}  // namespace

SplatFilm::SplatFilm(const Imath::Box2i& window, int cell_side, const PixelFilter& filter)
    : window_(window),
      side_(cell_side),
      corner_(aligned(window.min.x, side_), aligned(window.min.y, side_)),
      across_(filter, 0),
      down_(filter, 1),
      cells_(divided_up(window.max.x + 1 - corner_.x, side_),
             divided_up(window.max.y + 1 - corner_.y, side_)),
      before_(pixels_before(across_, down_)),
      block_(block_size(side_, across_, down_)),
      splats_(cells() * block_.x * block_.y),
      errors_(cell_side > 1 ? splats_.size() : 0) {}

double SplatFilm::bytes_per_pixel(int cell_side, const PixelFilter& filter) {
    const Imath::V2i block = block_size(cell_side, {filter, 0}, {filter, 1});
    const double splats = cell_side > 1 ? 2 : 1;  // sums and their errors
    return splats * sizeof(Splat) * block.x * block.y / (cell_side * cell_side);
}

std::size_t SplatFilm::cell_of(const Imath::V2i& pixel) const {
    const Imath::V2i offset = pixel - corner_;
    return static_cast<std::size_t>(offset.y / side_) * cells_.x + offset.x / side_;
}

std::uint64_t SplatFilm::bytes_of(const Imath::Box2i& window, int cell_side,
                                  const PixelFilter& filter) {
    const Imath::V2i block = block_size(cell_side, {filter, 0}, {filter, 1});
    std::uint64_t pixels = 1;
    for (int k = 0; k < 2; ++k) {
        const int corner = aligned(window.min[k], cell_side);
        pixels *= static_cast<std::uint64_t>(divided_up(window.max[k] + 1 - corner, cell_side)) *
                  block[k];
    }
    return pixels * sizeof(Splat) * (cell_side > 1 ? 2 : 1);  // sums and their errors
}

SplatSums SplatFilm::sums_from(std::size_t splat) {
    return {splats_[splat].values.data(), errors_.empty() ? nullptr : errors_[splat].values.data(),
            static_cast<std::size_t>(block_.x) * Splat::size};
}

/// Distances are measured from the cell's corner, so that all are rounded alike and stay within the
/// block.
void SplatFilm::add(const Imath::V2i& pixel, const Vec2& place, const Color& sample,
                    double weight) {
    const Imath::V2i offset = pixel - corner_;
    const Imath::V2i corner = pixel - Imath::V2i(offset.x % side_, offset.y % side_);
    const Weights x(across_, place.x - corner.x), y(down_, place.y - corner.y);
    if (x.count == 0 || y.count == 0) return;  // between the filters of two pixels
    const std::array<double, Splat::size> value{weight * sample.x, weight * sample.y,
                                                weight * sample.z, weight};
    const std::size_t first = cell_of(pixel) * block_.x * block_.y +
                              (y.first + before_.y) * block_.x + (x.first + before_.x);
    add_splats({value.data(), x.values.data(), y.values.data(), static_cast<std::size_t>(x.count),
                static_cast<std::size_t>(y.count)},
               sums_from(first));
}

void SplatFilm::add(const SplatFilm& other, const std::vector<double>& counts) {
    if (counts_.empty()) counts_.assign(counts.size(), 0);
    for (std::size_t i = 0; i < counts.size(); ++i) counts_[i] += counts[i];
    errors_.resize(splats_.size());
    parallel_for(splats_.size(), 1 << 12, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t k = 0; k < Splat::size; ++k) {
                const TwoTerm sum = two_sum(splats_[i].values[k], other.splats_[i].values[k]);
                splats_[i].values[k] = sum.value;
                errors_[i].values[k] += sum.error;
                if (!other.errors_.empty()) errors_[i].values[k] += other.errors_[i].values[k];
            }
        }
    });
}

std::vector<double> SplatFilm::counts(const Film& samples, const SampleRates& rates) const {
    if (!counts_.empty()) return counts_;
    std::vector<double> counts(cells(), 0);
    for (int y = window_.min.y; y <= window_.max.y; ++y) {
        for (int x = window_.min.x; x <= window_.max.x; ++x) {
            const std::size_t pixel = samples.index(x, y);
            counts[cell_of({x, y})] +=
                samples.counts()[pixel] / (rates.empty() ? 1.0 : rates[pixel]);
        }
    }
    return counts;
}

/// Returns the reciprocal of the number of samples that each pixel of a cell counts as; 0 if there
/// is none.
std::vector<double> SplatFilm::cell_weights(const Film& samples, const SampleRates& rates) const {
    std::vector<double> weights = counts(samples, rates);
    std::vector<std::uint64_t> pixels(weights.size(), 0);
    for (int y = window_.min.y; y <= window_.max.y; ++y) {
        for (int x = window_.min.x; x <= window_.max.x; ++x) ++pixels[cell_of({x, y})];
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] > 0) weights[i] = static_cast<double>(pixels[i]) / weights[i];
    }
    return weights;
}

/// Returns the cells whose blocks contain the pixel.
SplatFilm::Range SplatFilm::cells_about(int pixel, int axis) const {
    const int from_block = pixel - corner_[axis] + before_[axis];  // of the first cell
    return {std::max(0, divided_up(from_block - block_[axis] + 1, side_)),
            std::min(cells_[axis] - 1, from_block / side_)};
}

/// Adds to row `y` of the window the contributions of all cells.
void SplatFilm::add_row(int y, const Imath::Box2i& window, const std::vector<double>& cell_weights,
                        std::vector<Splat>& row) const {
    const Range rows = cells_about(y, 1);
    const Range columns{cells_about(window.min.x, 0).first, cells_about(window.max.x, 0).last};
    for (int cy = rows.first; cy <= rows.last; ++cy) {
        const int v = y - (corner_.y + cy * side_ - before_.y);
        for (int cx = columns.first; cx <= columns.last; ++cx) {
            const std::size_t cell = static_cast<std::size_t>(cy) * cells_.x + cx;
            const std::size_t first = (cell * block_.y + v) * block_.x;
            const int corner = corner_.x + cx * side_ - before_.x;
            const int last = std::min(window.max.x, corner + block_.x - 1);
            for (int x = std::max(window.min.x, corner); x <= last; ++x) {
                const std::array<double, Splat::size> splat = value(first + (x - corner));
                for (std::size_t k = 0; k < Splat::size; ++k) {
                    row[x - window.min.x].values[k] += cell_weights[cell] * splat[k];
                }
            }
        }
    }
}

std::vector<Vec3> SplatFilm::means(const Imath::Box2i& window, const Film& samples,
                                   const SampleRates& rates) const {
    const std::vector<double> weights = cell_weights(samples, rates);
    const auto width = static_cast<std::size_t>(window_size(window).x);
    std::vector<Vec3> result(pixel_count(window), Vec3(0));
    parallel_for(window_size(window).y, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            std::vector<Splat> splats(width);
            add_row(window.min.y + static_cast<int>(row), window, weights, splats);
            for (std::size_t i = 0; i < width; ++i) {
                const auto& [r, g, b, weight] = splats[i].values;
                if (weight == 0) continue;
                const Vec3 mean = Vec3(r, g, b) / weight;
                for (int k = 0; k < 3; ++k) result[row * width + i][k] = std::max(0.0, mean[k]);
            }
        }
    });
    return result;
}

}  // namespace etalon
