// Metrics of how far an image is from its reference: each a function of its own, so that a caller
// pays for what it asks. They use all threads and give the same bits for any number of them.
//
// Images are linear RGB and of one size, at least one pixel. Every channel of every pixel counts
// alike. Values that are equal, or both NaN, do not differ; otherwise NaN or infinity in either
// image is an infinite difference.
#pragma once

#include <cstdint>
#include <span>

#include "core/numerics/vec.h"

namespace etalon {

/// Pixels by rows from the top.
using Pixels = std::span<const Color>;

struct Metrics {
    double mse = 0, relmse = 0, mae = 0, psnr = 0, ssim = 0, flip = 0, max_abs = 0;
    std::uint64_t different_pixels = 0;
    Vec3 mean_a{0}, mean_b{0};
};

/// Mean of (a - b)^2.
double mse(Pixels a, Pixels b);

/// Mean of (a - b)^2 / (b^2 + 0.01): what noise in the dark is seen as. Rousselle et al. 2011,
/// "Adaptive Sampling and Reconstruction using Greedy Error Minimization".
double relmse(Pixels a, Pixels reference);

/// Mean of |a - b|.
double mae(Pixels a, Pixels b);

/// Decibels from this mean squared error up to the square of 1, the white of a display; infinite
/// where the images are equal, minus infinite where the error is infinite.
double psnr(double mse);

/// The largest |a - b|.
double max_abs(Pixels a, Pixels b);

/// How many pixels differ in any channel, by however little.
std::uint64_t different_pixels(Pixels a, Pixels b);

/// How many pixels have NaN or an infinity in a channel.
std::uint64_t unbounded_pixels(Pixels pixels);

/// Mean of each channel; NaN and infinities are not left out.
Vec3 mean(Pixels pixels);

}  // namespace etalon
