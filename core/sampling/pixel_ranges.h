#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/pixel_run.h"
#include "core/sampling/sample_source.h"

namespace etalon {

/// Ranges of the samples of many pixels, in SoA layout, so that names and points of all are
/// computed together: they are those of PixelSamples. Reused from batch to batch.
class PixelRanges {
  public:
    PixelRanges(std::uint64_t seed, Sampler sampler) : seed_(seed), sampler_(sampler) {}

    /// Adds the samples [first, last) of the pixel (x, y).
    void add(int x, int y, std::uint32_t first, std::uint32_t last) {
        const auto begin = static_cast<std::uint32_t>(samples());
        runs_.push_back({{x, y}, begin, begin + (last - first)});
        firsts_.push_back(first);
    }

    /// Returns the number of samples in all ranges.
    std::size_t samples() const { return runs_.empty() ? 0 : runs_.back().last; }

    /// Returns the ranges as runs of the samples of all, in the order in which they were added.
    std::span<const PixelRun> runs() const { return runs_; }

    /// Names the pixels, which the members below need.
    void name();

    /// Lists the source of each sample.
    void list(std::vector<SampleSource>& sources) const;

    /// Sets the points of a dimension of all samples.
    void make_points(std::uint32_t dimension, std::vector<Vec2>& points);

    void clear() {
        runs_.clear();
        firsts_.clear();
    }

  private:
    /// A value for each range, or for each sample; padded.
    using Column = std::vector<std::uint32_t>;

    void make_sobol_points(std::vector<Vec2>& points);
    void make_random_points(std::vector<Vec2>& points) const;

    std::uint64_t seed_;
    Sampler sampler_;
    std::vector<PixelRun> runs_;
    Column firsts_;           ///< numbers of their first samples; not padded
    Column xs_, ys_, names_;  ///< of their pixels
    Column seeds_;            ///< of the sets of a dimension
    Column orders_, x_scrambles_, y_scrambles_;
    Column sample_indices_, sample_orders_, sample_xs_, sample_ys_;
};

}  // namespace etalon
