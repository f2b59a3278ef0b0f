#pragma once

#include "core/render/deadline.h"
#include "core/render/sampling_passes.h"

namespace etalon {

/// The same number of samples for every pixel, doubled round by round: what there is at any time is
/// well distributed. The last pass before a deadline is as large as there is time for.
class UniformPasses : public SamplingPasses {
  public:
    /// Plans `samples` samples of each of `pixels` pixels, at least 1.
    UniformPasses(std::uint32_t samples, std::size_t pixels, const Deadline& deadline)
        : samples_(samples), pixels_(pixels), deadline_(deadline) {}

    std::optional<SamplingGoal> next(const Film& film) override;
    bool is_complete(std::uint64_t samples) const override;
    double progress(std::uint64_t samples) const override;

  private:
    std::uint32_t affordable() const;
    std::uint64_t all_samples() const { return std::uint64_t{samples_} * pixels_; }

    std::uint32_t samples_, goal_ = 0;
    std::size_t pixels_;
    const Deadline& deadline_;
};

}  // namespace etalon
