// Order in which samples are taken. An image is rendered in passes; after each pass it is complete.
#pragma once

#include <optional>
#include <vector>

#include "core/render/film.h"
#include "core/render/state.h"

namespace etalon {

/// Number of samples of pixels at the end of a pass.
struct SamplingGoal {
    std::uint32_t all = 0;                  ///< samples of every pixel, if of_pixel is empty
    std::vector<std::uint32_t> of_pixel{};  ///< samples of each pixel

    std::uint32_t of(std::size_t pixel) const { return of_pixel.empty() ? all : of_pixel[pixel]; }

    template <class Bytes>
    void transfer(Bytes& bytes) {
        bytes(all);
        bytes(of_pixel);
    }
};

class SamplingPasses {
  public:
    virtual ~SamplingPasses() = default;

    /// Returns the goal of the next pass; nothing when the image is done.
    virtual std::optional<SamplingGoal> next(const Film& film) = 0;

    /// Returns whether the image is complete after so many samples. next() also ends the passes if
    /// there is no time for more.
    virtual bool is_complete(std::uint64_t samples) const = 0;

    /// Returns the image's expected relMSE after the last whole pass; nothing if it was not
    /// estimated.
    virtual std::optional<double> expected_error() const { return std::nullopt; }

    /// Returns whether the samples allowed were too few for a target error.
    virtual bool misses_target() const { return false; }

    /// Write and read the state of next() and expected_error() beside a film of so many samples.
    virtual void save(StateWriter& bytes) = 0;
    virtual void restore(StateReader& bytes, std::uint64_t samples) = 0;

    /// Returns the fraction of the work that is done after so many samples, in [0, 1].
    virtual double progress(std::uint64_t samples) const = 0;
};

}  // namespace etalon
