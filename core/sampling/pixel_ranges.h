#pragma once

#include <cstdint>
#include <vector>

#include "core/numerics/vec.h"
#include "core/sampling/sample_source.h"

namespace etalon {

/// Ranges of the samples of many pixels, in SoA layout, so that names and points of all are
/// computed together: they are those of PixelSamples. Reused from batch to batch.
class PixelRanges {
  public:
    PixelRanges(std::uint64_t seed, Sampler sampler) : seed_(seed), sampler_(sampler) {}

    /// Adds the samples [first, last) of the pixel (x, y).
    void add(int x, int y, std::uint32_t first, std::uint32_t last);

    /// Returns the number of samples in all ranges.
    std::size_t samples() const { return samples_; }

    /// Names the pixels, which the members below need.
    void name();

    /// Set the pixel, or the source, of each sample, in the order in which they were added.
    void list_pixels(std::vector<Imath::V2i>& pixels) const;
    void list_sources(std::vector<SampleSource>& sources) const;

    /// Sets the points of a dimension of all samples in that order.
    void make_points(std::uint32_t dimension, std::vector<Vec2>& points);

    void clear() { count_ = samples_ = 0; }

  private:
    /// A value for each range, or for each sample; padded.
    using Column = std::vector<std::uint32_t>;

    void make_sobol_points(std::vector<Vec2>& points);
    void make_random_points(std::vector<Vec2>& points) const;

    std::uint64_t seed_;
    Sampler sampler_;
    std::size_t count_ = 0, samples_ = 0;
    Column xs_, ys_, firsts_, lasts_;  ///< of the ranges
    Column names_;                     ///< of their pixels
    Column seeds_;                     ///< of the sets of a dimension
    Column orders_, x_scrambles_, y_scrambles_;
    Column sample_indices_, sample_orders_, sample_xs_, sample_ys_;
};

}  // namespace etalon
