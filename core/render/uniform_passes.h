#pragma once

#include <algorithm>
#include <numeric>

#include "core/render/deadline.h"
#include "core/render/sample_rates.h"
#include "core/render/sampling_passes.h"

namespace etalon {

/// Takes the same number of samples for every pixel, times the pixel's rate. The number is doubled
/// from pass to pass, or more than doubled if that makes a pass of a few samples only, so that the
/// samples are well distributed at any time. The last pass before a deadline is as large as the
/// time allows.
class UniformPasses : public SamplingPasses {
  public:
    /// Plans `samples` samples of each of `pixels` pixels, at least 1, times their `rates`. Between
    /// the first pass and the last, passes have at least about `least` samples of all pixels.
    UniformPasses(std::uint32_t samples, std::size_t pixels, const Deadline& deadline,
                  SampleRates rates = {}, std::uint64_t least = 0)
        : samples_(samples),
          samples_of_one_(rates.empty() ? pixels : std::reduce(rates.begin(), rates.end(), 0ULL)),
          least_of_one_(std::min<std::uint64_t>(least / std::max<std::uint64_t>(samples_of_one_, 1),
                                                samples)),
          rates_(std::move(rates)),
          deadline_(deadline) {}

    std::optional<SamplingGoal> next(const Film& film) override;
    bool is_complete(std::uint64_t samples) const override;
    double progress(std::uint64_t samples) const override;
    void save(StateWriter& bytes) override { bytes(goal_); }
    void restore(StateReader& bytes, std::uint64_t samples) override;

  private:
    std::uint32_t affordable() const;
    SamplingGoal goal() const;
    std::uint64_t all_samples() const { return samples_ * samples_of_one_; }

    std::uint32_t samples_, goal_ = 0;
    double done_before_ = 0;        ///< samples of a pixel of rate 1 when the deadline's time began
    std::uint64_t samples_of_one_;  ///< samples of all pixels if a pixel of rate 1 has one
    std::uint64_t least_of_one_;    ///< samples that a pass adds at least to a pixel of rate 1
    SampleRates rates_;
    const Deadline& deadline_;
};

}  // namespace etalon
