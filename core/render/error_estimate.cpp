#include "core/render/error_estimate.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// Number of pixels on a side of a block. Smaller ones know less of their rate; larger ones mix
/// what converges fast, open surfaces, with what converges slowly, edges and shadows.
constexpr int block_size = 32;

/// Largest distance of a pixel's neighbours. With fewer neighbours the estimate is too noisy to
/// choose pixels: those whose error was underestimated by chance would get no more samples.
constexpr int reach = 2;

/// Weights by the distance along a row and along a column: 2^-(distance^2 / 2).
constexpr double fall_off[reach + 1] = {1, 0.70710678118654752, 0.25};

/// Rate as long as nothing is known.
constexpr double usual_rate = 1.25;

double relative_square(const Vec3& difference, const Vec3& value) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        sum += difference[k] * difference[k] / (value[k] * value[k] + 0.01);
    }
    return sum / 3;
}

/// The same for the light for which display values stand: a small difference is multiplied by the
/// slope of the curve.
double decoded_relative_square(const Vec3& difference, const Vec3& value) {
    Vec3 light, change;
    for (int k = 0; k < 3; ++k) {
        light[k] = srgb_decoded(value[k]);
        change[k] = difference[k] * srgb_slope(value[k], light[k]);
    }
    return relative_square(change, light);
}

/// Returns the exponent of a power law for V where one change is `ratio` times the next. V is a sum
/// of parts that fall as 1 / n, where the samples might as well be random, and of faster ones; the
/// slow ones matter in the long run. Modelled as a / n + b / n^2, V is (5 - ratio) / 3 of the last
/// change. The ratio is only used within a fall by two to four.
double rate_of(double ratio) {
    const double left = std::clamp((5 - ratio) / 3, 1.0 / 3, 1.0);
    return std::log2(1 + 1 / left);
}

/// Returns V(n) as a fraction of V(n/2) - V(n).
double left_after(double rate) {
    return 1 / (std::exp2(rate) - 1);
}

int blocks(int pixels) {
    return (pixels + block_size - 1) / block_size;
}

}  // namespace

ErrorEstimate::ErrorEstimate(int width, int height, bool decodes)
    : width_(width),
      height_(height),
      decodes_(decodes),
      sums_(static_cast<std::size_t>(width) * height, Vec3(0)),
      counts_(sums_.size(), 0),
      changes_(sums_.size(), 0),
      changes_before_(sums_.size(), 0),
      after_one_(sums_.size(), 0),
      rates_(static_cast<std::size_t>(blocks(width)) * blocks(height), usual_rate) {}

std::size_t ErrorEstimate::block(int x, int y) const {
    return static_cast<std::size_t>(y / block_size) * blocks(width_) + x / block_size;
}

void ErrorEstimate::look(const Film& film, const FilteredErrors* filtered) {
    std::vector<std::uint8_t> doubled(sums_.size(), 0);
    parallel_for(sums_.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) doubled[i] = look_at_pixel(i, film, filtered);
    });
    exists_ = exists_ || std::find(doubled.begin(), doubled.end(), 1) != doubled.end();
    if (filtered) match(filtered->change, doubled);
    learn_rates();
    compare_neighbours();
}

/// Scales the changes of the pixels that were doubled so that their sum is the image's. Samples
/// that are well distributed over a pixel are less so under a part of a filter, by an amount that
/// depends on the scene.
void ErrorEstimate::match(double change, const std::vector<std::uint8_t>& doubled) {
    double sum = 0;
    for (std::size_t i = 0; i < changes_.size(); ++i) sum += doubled[i] ? changes_[i] : 0;
    if (sum == 0) return;
    const double scale = change * static_cast<double>(changes_.size()) / sum;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
        if (doubled[i]) changes_[i] *= scale;
    }
}

/// Adjusts the changes of a pixel whose samples became more but were not doubled to those that
/// doubling to the same number would have made.
void ErrorEstimate::extrapolate(std::size_t i, std::uint32_t count) {
    const int x = static_cast<int>(i) % width_, y = static_cast<int>(i) / width_;
    const double fall = std::pow(static_cast<double>(counts_[i]) / count, rate(x, y));
    changes_[i] *= fall;
    changes_before_[i] *= fall;
}

/// Returns whether the pixel's samples were doubled.
bool ErrorEstimate::look_at_pixel(std::size_t i, const Film& film, const FilteredErrors* filtered) {
    const bool doubled = counts_[i] > 0 && film.counts()[i] == 2 * counts_[i];
    if (doubled) {
        const Vec3 half = sums_[i] / counts_[i];
        const Vec3 other_half = (film.sum(i) - sums_[i]) / counts_[i];
        changes_before_[i] = changes_[i];
        const Vec3 change = (half - other_half) / 2;
        const auto square = decodes_ ? decoded_relative_square : relative_square;
        changes_[i] = filtered ? (change * change).dot(filtered->factors[i]) / 3
                               : square(change, film.mean(i));
    } else if (counts_[i] > 0 && film.counts()[i] > counts_[i]) {
        extrapolate(i, film.counts()[i]);
    }
    sums_[i] = film.sum(i);
    counts_[i] = film.counts()[i];
    return doubled;
}

void ErrorEstimate::learn_rates() {
    std::vector<double> before(rates_.size(), 0), after(rates_.size(), 0);
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            if (counts_[index(x, y)] < 4) continue;  // doubled only once
            before[block(x, y)] += changes_before_[index(x, y)];
            after[block(x, y)] += changes_[index(x, y)];
        }
    }
    for (std::size_t b = 0; b < rates_.size(); ++b) {
        if (before[b] > 0 && after[b] > 0) rates_[b] = rate_of(before[b] / after[b]);
    }
}

double ErrorEstimate::total() const {
    double sum = 0;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) sum += changes_[index(x, y)] * left_after(rate(x, y));
    }
    return sum / static_cast<double>(changes_.size());
}

/// Compares neighbours. Those with different numbers of samples are compared by their errors after
/// one sample.
void ErrorEstimate::compare_neighbours() {
    parallel_for(static_cast<std::size_t>(height_), 1, [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < width_; ++x) {
                const std::size_t i = index(x, y);
                after_one_[i] = changes_[i] == 0 ? 0
                                                 : changes_[i] * left_after(rate(x, y)) *
                                                       std::pow(counts_[i], rate(x, y));
            }
        }
    });
}

/// Weights neighbours by their distance.
double ErrorEstimate::by_neighbours(int x, int y) const {
    double sum = 0, weights = 0;
    for (int v = std::max(0, y - reach); v <= std::min(height_ - 1, y + reach); ++v) {
        for (int u = std::max(0, x - reach); u <= std::min(width_ - 1, x + reach); ++u) {
            if (u == x && v == y) continue;
            const double weight = fall_off[std::abs(u - x)] * fall_off[std::abs(v - y)];
            sum += weight * after_one_[index(u, v)];
            weights += weight;
        }
    }
    const double after_one = weights > 0 ? sum / weights : after_one_[0];  // of a single pixel
    return after_one * std::pow(counts_[index(x, y)], -rate(x, y));
}

}  // namespace etalon
