#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/pixel_run.h"
#include "core/parallel/large_pages.h"

namespace etalon {

/// Sums of samples, pixel by pixel, over a window of the image. Threads may add to different
/// pixels at the same time. Pixels are numbered by rows from the top.
class Film {
  public:
    /// Film of `window`, inclusive on both ends; `with_squares` keeps the sums that variances need.
    explicit Film(const Imath::Box2i& window, bool with_squares = false);

    void add(int x, int y, const Color& sample);

    /// Adds the samples of several pixels.
    void add(std::span<const PixelRun> runs, std::span<const Color> samples);

    /// Adds the samples of another film of the same window. The rounding errors of the sums are
    /// stored separately, so that the order in which films are added does not matter.
    void add(const Film& other);

    const Imath::Box2i& window() const { return window_; }
    int width() const { return width_; }
    std::size_t size() const { return sums_.size(); }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - window_.min.y) * width_ + (x - window_.min.x);
    }

    const Vec3& sum(std::size_t pixel) const { return sums_[pixel]; }
    const std::vector<std::uint32_t>& counts() const { return counts_; }
    std::uint64_t total_count() const;

    /// Returns the mean of the samples, or the filtered value if there is one; black where there is
    /// no sample yet.
    Vec3 mean(std::size_t pixel) const {
        return filtered_means_.empty() ? sample_mean(pixel) : filtered_means_[pixel];
    }

    /// Returns the means of all pixels.
    std::vector<Color> pixels() const;

    /// Returns the unbiased variance of each pixel's samples (Bessel); 0 below two samples. It is
    /// not the variance of their mean, which for well distributed samples is smaller than a share
    /// of it. Needs squares.
    std::vector<Color> variances() const;

    /// Converts a film of a grid's corners to one of its cells, each with the samples of its four
    /// corners. The result is smaller by one in both directions.
    Film cells() const;

    /// Returns the part of the film in a window, with the filtered means of all samples. Counts and
    /// variances remain those of each pixel's own samples.
    Film filtered(const Imath::Box2i& window, std::vector<Vec3> means) const;

    template <class Bytes>
    void transfer(Bytes& bytes) {
        bytes(sums_);
        bytes(squares_);
        bytes(counts_);
        bytes(errors_);
        bytes.expect(squares_.empty() || squares_.size() == sums_.size());
        bytes.expect(errors_.empty() || errors_.size() == sums_.size());
    }

    /// Transfers only the pixels of a tile, of a film to which no other was added.
    template <class Bytes>
    void transfer(Bytes& bytes, const Imath::Box2i& tile) {
        for (int y = tile.min.y; y <= tile.max.y; ++y) {
            for (std::size_t i = index(tile.min.x, y); i <= index(tile.max.x, y); ++i) {
                bytes(sums_[i]);
                bytes(counts_[i]);
                if (!squares_.empty()) bytes(squares_[i]);
            }
        }
    }

  private:
    Vec3 sample_mean(std::size_t pixel) const {
        if (counts_[pixel] == 0) return Vec3(0);
        return (errors_.empty() ? sums_[pixel] : sums_[pixel] + errors_[pixel]) / counts_[pixel];
    }
    void add_all(std::size_t pixel, const Film& from, std::size_t pixel_of_it);

    Imath::Box2i window_;
    int width_;
    std::vector<Vec3, LargePages<Vec3>> sums_, squares_;  ///< squares: empty unless requested
    std::vector<Vec3, LargePages<Vec3>> errors_;  ///< rounding errors of the sums; empty unless
    ///< films were added
    std::vector<std::uint32_t> counts_;
    std::vector<Vec3> filtered_means_;  ///< empty if the image is not filtered
};

}  // namespace etalon
