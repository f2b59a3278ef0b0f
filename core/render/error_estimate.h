#pragma once

#include <vector>

#include "core/render/film.h"

namespace etalon {

/// What errors of pixels are to an image whose filter spreads samples over several.
struct FilteredErrors {
    /// What a squared error of a pixel's mean adds to the image's relMSE, by channels; their mean
    /// over the pixels is that of the image.
    std::vector<Vec3> factors;
    /// relMSE of the image as it was when last looked at, had it come to be what it is now.
    double change;
};

/// How far each pixel of a film still is from its limit, told from how much it changed when its
/// samples were doubled.
///
/// Let V(n) be the expected squared error of a pixel after n samples of an Owen-scrambled sequence,
/// both halves of which are as well distributed as each other. A quarter of the squared difference
/// of their means has the expectation V(n/2) - V(n), be they independent or not. How V goes on
/// falls out of two such changes in a row, taken together over a block of pixels.
class ErrorEstimate {
  public:
    /// `decodes`: the error is that of the light for which the film's display values stand.
    ErrorEstimate(int width, int height, bool decodes);

    /// Looks at a film each of whose pixels has as many samples as when last looked at, or twice as
    /// many; others tell nothing. With `filtered`, it is the error of the filtered image that is
    /// estimated.
    void look(const Film& film, const FilteredErrors* filtered = nullptr);

    /// Returns whether there is an estimate: some pixels were doubled.
    bool exists() const { return exists_; }

    /// relMSE of the image: the mean over pixels and channels of (error / value)^2, with 0.01
    /// added to the squared value.
    double total() const;

    /// The same of one pixel, as its neighbours have it. What a single pixel changed says little;
    /// and as long as its own samples do not decide how many more it gets, that biases neither its
    /// mean nor its part of the total.
    double by_neighbours(int x, int y) const;

    /// Rate p: by doubling a pixel's samples its error falls to 2^-p.
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
    std::vector<double> changes_, changes_before_;  ///< two last relative changes of V per pixel
    std::vector<double> after_one_;                 ///< the error of each pixel, had it one sample
    std::vector<double> rates_;                     ///< rates of blocks
};

}  // namespace etalon
