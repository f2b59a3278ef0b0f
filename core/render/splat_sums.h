#pragma once

#include <cstddef>

#include "core/scene/pixel_filter.h"

namespace etalon {

/// A sample whose weighted values are added to those of the pixels around it: of `rows` rows of
/// `columns` pixels.
struct WeightedSample {
    static constexpr std::size_t channels = 4;
    /// Largest number of columns or rows.
    static constexpr std::size_t most_pixels = 2 * static_cast<std::size_t>(max_filter_radius) + 2;

    const double* values;         ///< one for each channel
    const double *across, *down;  ///< weights of the columns and of the rows
    std::size_t columns, rows;
};

/// Sums of the pixels, interleaved by channel, from the first of a sample's pixels on.
struct SplatSums {
    double* sums;
    double* errors;      ///< rounding errors of these; null if they are not kept
    std::size_t stride;  ///< from a row to the next
};

/// Adds the products of a value and two weights to the sums.
void add_splats(const WeightedSample& sample, const SplatSums& to);

}  // namespace etalon
