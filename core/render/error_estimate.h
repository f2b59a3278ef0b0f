#pragma once

#include <vector>

#include "core/render/film.h"

namespace etalon {

/// Contributions of pixel errors to an image whose filter spreads samples over several pixels.
struct FilteredErrors {
    /// Contribution of a squared error of each pixel's mean to the image's relMSE, by channel;
    /// their mean over the pixels is that of the image.
    std::vector<Vec3> factors;
    /// relMSE of the previous image relative to the current one.
    double change;
};

/// Estimates how far each pixel of a film still is from its limit, from how much it changed when
/// its samples were doubled.
///
/// Let V(n) be the expected squared error of a pixel after n samples of an Owen-scrambled sequence,
/// whose two halves are equally well distributed. A quarter of the squared difference of their
/// means has the expectation V(n/2) - V(n), whether they are independent or not. Two such changes
/// in a row, summed over a block of pixels, tell how V continues.
class ErrorEstimate {
  public:
    /// If `decodes`, the error is that of the light for which the film's display values stand.
    ErrorEstimate(int width, int height, bool decodes);

    /// Looks at a film. Pixels whose samples have doubled since the last call contribute; the error
    /// of those that have more samples, but not twice as many, falls at the rate known so far. With
    /// `filtered`, estimates the error of the filtered image.
    void look(const Film& film, const FilteredErrors* filtered = nullptr);

    /// Returns whether there is an estimate, which needs pixels whose samples were doubled.
    bool exists() const { return exists_; }

    /// Returns the relMSE of the image: the mean over pixels and channels of (error / value)^2,
    /// with 0.01 added to the squared value.
    double total() const;

    /// Returns the relMSE of one pixel, estimated from its neighbours. The change of a single pixel
    /// says little. Moreover, as long as a pixel's own samples do not decide how many more it gets,
    /// neither its mean nor its part of the total is biased.
    double by_neighbours(int x, int y) const;

    /// Returns the rate p: doubling a pixel's samples multiplies its error by 2^-p.
    double rate(int x, int y) const { return rates_[block(x, y)]; }

    template <class Bytes>
    void transfer(Bytes& bytes) {
        bytes(exists_);
        bytes(sums_);
        bytes(counts_);
        bytes(changes_);
        bytes(changes_before_);
        bytes(rates_);
    }

  private:
    bool look_at_pixel(std::size_t pixel, const Film& film, const FilteredErrors* filtered);
    void extrapolate(std::size_t pixel, std::uint32_t count);
    void match(double change, const std::vector<std::uint8_t>& doubled);
    void learn_rates();
    void compare_neighbours();

    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
    std::size_t block(int x, int y) const;

    int width_, height_;
    bool decodes_;
    bool exists_ = false;
    std::vector<Vec3> sums_;
    std::vector<std::uint32_t> counts_;
    std::vector<double> changes_, changes_before_;  ///< last two relative changes of V per pixel
    std::vector<double> after_one_;                 ///< error of each pixel if it had one sample
    std::vector<double> rates_;                     ///< rates of blocks
};

}  // namespace etalon
