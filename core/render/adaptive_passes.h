#pragma once

#include "core/render/pass_errors.h"
#include "core/render/sampling_passes.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Takes samples where they lower the error most, until the image's expected relMSE is `error`. A
/// pixel's samples are doubled each time, so that they stay well distributed.
class AdaptivePasses : public SamplingPasses {
  public:
    /// Plans passes for images like this one, with at most `samples` samples of a pixel.
    AdaptivePasses(const ImageFilm& image, const RenderSettings& settings, std::uint32_t samples);

    std::optional<SamplingGoal> next(const Film& film) override;
    bool is_complete(std::uint64_t) const override { return is_complete_; }
    std::optional<double> expected_error() const override;
    bool misses_target() const override;
    double progress(std::uint64_t samples) const override;
    void save(StateWriter& bytes) override { transfer(bytes); }
    void restore(StateReader& bytes, std::uint64_t) override { transfer(bytes); }

  private:
    /// A pixel whose samples might be doubled.
    struct Candidate {
        double gain;  ///< decrease of the sum of the pixels' errors, for each sample
        std::uint32_t pixel;
    };

    template <class Bytes>
    void transfer(Bytes& bytes) {
        errors_.transfer(bytes);
        bytes(expected_);
        bytes(of_all_);
        bytes(is_complete_);
    }

    std::optional<SamplingGoal> plan(const Film& film);
    bool is_enough() const;
    bool knows_too_little() const;
    std::vector<Candidate> candidates(const Film& film) const;
    SamplingGoal worthwhile(const Film& film) const;

    PassErrors errors_;
    double error_, fewest_, expected_ = 0;
    std::uint32_t samples_, of_all_ = 0;
    bool is_complete_ = false;
};

}  // namespace etalon
