#include "core/image/metrics/ssim.h"

#include <numeric>

#include "core/color/srgb.h"
#include "core/image/metrics/convolve.h"

namespace etalon {
namespace {

constexpr int window_radius = 5;
constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;  // (K1 L)^2, (K2 L)^2 for a range L of 1

Filter window() {
    return normalized(
        filter_of(window_radius, [](int x) { return std::exp(-x * x / (2 * 1.5 * 1.5)); }));
}

PixelPlane encoded_channel(Pixels pixels, int width, int channel) {
    return plane_of(width, static_cast<int>(pixels.size()) / width,
                    [&](std::size_t i) { return srgb_encoded(displayed(pixels[i][channel])); });
}

/// Weighted means of two planes in a window around each pixel: of each, of the sum of their
/// squares, and of their product.
struct Moments {
    PixelPlane a, b, squares, product;
};

Moments moments(const PixelPlane& a, const PixelPlane& b) {
    const Filter w = window();
    const auto seen = [&](const auto& value) {
        return convolve(plane_of(a.width, a.height, value), w, w);
    };
    const auto &p = a.values, &q = b.values;
    return {convolve(a, w, w), convolve(b, w, w),
            seen([&](std::size_t i) { return p[i] * p[i] + q[i] * q[i]; }),
            seen([&](std::size_t i) { return p[i] * q[i]; })};
}

/// Similarity at a pixel: equation 13 of the paper.
double similarity(const Moments& m, std::size_t i) {
    const double a = m.a.values[i], b = m.b.values[i];
    const double squares = a * a + b * b, product = a * b;
    const double variances = m.squares.values[i] - squares;
    const double covariance = m.product.values[i] - product;
    return (2 * product + c1) * (2 * covariance + c2) / ((squares + c1) * (variances + c2));
}

int margin(int side) {
    return side > 2 * window_radius ? window_radius : 0;
}

double mean_similarity(const Moments& m) {
    const int left = margin(m.a.width), top = margin(m.a.height);
    const int columns = m.a.width - 2 * left, rows = m.a.height - 2 * top;
    std::vector<double> sums(rows);
    for_each_row(rows, [&](int y) {
        const std::size_t first = static_cast<std::size_t>(top + y) * m.a.width + left;
        for (std::size_t i = first; i < first + columns; ++i) sums[y] += similarity(m, i);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0) / columns / rows;
}

}  // namespace

double ssim(Pixels a, Pixels b, int width) {
    double sum = 0;
    for (int channel = 0; channel < 3; ++channel) {
        sum += mean_similarity(
            moments(encoded_channel(a, width, channel), encoded_channel(b, width, channel)));
    }
    return sum / 3;
}

}  // namespace etalon
