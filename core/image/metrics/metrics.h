// Metrics of the difference between an image and its reference. Each is a function of its own, so
// that a caller pays only for those it needs. They use all threads and give the same bits for any
// number of them.
//
// Images are linear RGB, or where only numbers are compared display values, and of one size, at
// least one pixel. Every channel of every pixel has the same weight. Values that are equal, or both
// NaN, do not differ; otherwise NaN or infinity in either image is an infinite difference.
#pragma once

#include <cstdint>
#include <span>

#include "core/numerics/vec.h"

namespace etalon {

/// Pixels in rows from the top.
using Pixels = std::span<const Color>;

struct Metrics {
    double mse = 0, relmse = 0, mae = 0, psnr = 0, ssim = 0, flip = 0, max_abs = 0;
    std::uint64_t different_pixels = 0;
    Vec3 mean_a{0}, mean_b{0};
};

/// Returns the mean of (a - b)^2.
double mse(Pixels a, Pixels b);

/// Returns the mean of (a - b)^2 / (b^2 + 0.01), in which noise in the dark counts as it is seen.
/// Rousselle et al. 2011, "Adaptive Sampling and Reconstruction using Greedy Error Minimization".
double relmse(Pixels a, Pixels reference);

/// Returns the mean of |a - b|.
double mae(Pixels a, Pixels b);

/// Returns the peak signal-to-noise ratio in decibels for this mean squared error and a peak of 1,
/// the white of a display; infinite if the images are equal, minus infinite if the error is
/// infinite.
double psnr(double mse);

/// Returns the largest |a - b|.
double max_abs(Pixels a, Pixels b);

/// Returns the number of pixels that differ in any channel, by any amount.
std::uint64_t different_pixels(Pixels a, Pixels b);

/// Returns the number of pixels with NaN or an infinity in a channel.
std::uint64_t unbounded_pixels(Pixels pixels);

/// Returns the mean of each channel, including NaN and infinities.
Vec3 mean(Pixels pixels);

}  // namespace etalon
