#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/parallel/large_pages.h"
#include "core/render/film.h"
#include "core/render/filter_axis.h"
#include "core/render/sample_rates.h"
#include "core/render/splat_sums.h"

namespace etalon {

/// Film whose samples contribute to all pixels near them, with the weights of a filter. The image's
/// pixels are divided into square cells. The contributions of a cell's samples, to its own pixels
/// and to those around, are summed separately from other cells. So threads may add samples to
/// different cells at the same time, and the image does not depend on their order.
class SplatFilm {
  public:
    /// Makes a film for samples of the pixels of `window`, inclusive on both ends. Cells are
    /// `cell_side` pixels wide; they are the same for any window, so that a part of an image has
    /// the same bits as the whole.
    SplatFilm(const Imath::Box2i& window, int cell_side, const PixelFilter& filter);

    /// Adds a sample at `place`, in pixels, of the pixel in which it lies. It counts as `weight`
    /// samples: the reciprocal of the pixel's rate.
    void add(const Imath::V2i& pixel, const Vec2& place, const Color& sample, double weight = 1);

    /// Returns the pixels of `window` in rows: weighted means of the samples near them, not below
    /// 0, and black where there is none. A cell's samples count as if there were one of each pixel;
    /// `samples` has their true number, and `rates` how many samples of a pixel count as one.
    std::vector<Vec3> means(const Imath::Box2i& window, const Film& samples,
                            const SampleRates& rates = {}) const;

    /// Adds the samples of another film of the same window and filter; `counts` are the numbers of
    /// samples of its cells. The order in which films are added does not matter.
    void add(const SplatFilm& other, const std::vector<double>& counts);

    /// Returns the number of samples of each cell, where samples of pixels with a rate count less.
    std::vector<double> counts(const Film& samples, const SampleRates& rates) const;

    /// Returns the corner of the first cell, which is at the window's corner or before it.
    const Imath::V2i& corner() const { return corner_; }

    /// Returns the bytes of memory for each pixel.
    static double bytes_per_pixel(int cell_side, const PixelFilter& filter);

    /// Returns the bytes of memory of the sums of a film with these arguments.
    static std::uint64_t bytes_of(const Imath::Box2i& window, int cell_side,
                                  const PixelFilter& filter);

    template <class Bytes>
    void transfer(Bytes& bytes) {
        bytes(splats_);
        bytes(errors_);
        bytes(counts_);
        bytes.expect(errors_.empty() || errors_.size() == splats_.size());
        bytes.expect(counts_.empty() || counts_.size() == cells());
    }

    /// Transfers only the cells of a tile, of a film to which no other was added.
    template <class Bytes>
    void transfer(Bytes& bytes, const Imath::Box2i& tile) {
        for (int y = tile.min.y; y <= tile.max.y; ++y) {
            for (int x = tile.min.x; x <= tile.max.x; ++x) {
                if (is_first_of_cell({x, y}, tile)) transfer_cell(bytes, cell_of({x, y}));
            }
        }
    }

  private:
    /// Sums of weighted samples, by channel, and of their weights.
    struct Splat {
        static constexpr std::size_t size = WeightedSample::channels;
        std::array<double, size> values{};
    };

    /// Range of cells, or of pixels, along one axis.
    struct Range {
        int first, last;
    };

    /// Returns the sums of a pixel of a block.
    std::array<double, Splat::size> value(std::size_t splat) const {
        std::array<double, Splat::size> sum = splats_[splat].values;
        if (errors_.empty()) return sum;
        for (std::size_t k = 0; k < Splat::size; ++k) sum[k] += errors_[splat].values[k];
        return sum;
    }

    /// Returns the sums from that splat on.
    SplatSums sums_from(std::size_t splat);

    std::size_t cells() const { return static_cast<std::size_t>(cells_.x) * cells_.y; }
    std::size_t cell_of(const Imath::V2i& pixel) const;

    /// Returns whether the pixel is the first one of its cell that is in the tile.
    bool is_first_of_cell(const Imath::V2i& pixel, const Imath::Box2i& tile) const {
        const Imath::V2i offset = pixel - corner_;
        return (offset.x % side_ == 0 || pixel.x == tile.min.x) &&
               (offset.y % side_ == 0 || pixel.y == tile.min.y);
    }

    template <class Bytes>
    void transfer_cell(Bytes& bytes, std::size_t cell) {
        const std::size_t size = static_cast<std::size_t>(block_.x) * block_.y;
        for (std::size_t i = cell * size; i < (cell + 1) * size; ++i) {
            bytes(splats_[i].values);
            if (!errors_.empty()) bytes(errors_[i].values);
        }
    }

    std::vector<double> cell_weights(const Film& samples, const SampleRates& rates) const;
    Range cells_about(int pixel, int axis) const;
    void add_row(int y, const Imath::Box2i& window, const std::vector<double>& cell_weights,
                 std::vector<Splat>& row) const;

    Imath::Box2i window_;
    int side_;
    Imath::V2i corner_;
    FilterAxis across_, down_;
    Imath::V2i cells_;   ///< number of cells along both axes
    Imath::V2i before_;  ///< number of pixels by which a block begins before its cell
    Imath::V2i block_;   ///< size in pixels of the area that a cell's samples affect
    std::vector<Splat, LargePages<Splat>> splats_;  ///< blocks, one after the other, in rows
    /// Rounding errors of these sums, so that the order of samples does not matter. Empty for cells
    /// of one pixel, for which they would double the memory.
    std::vector<Splat, LargePages<Splat>> errors_;
    std::vector<double> counts_;  ///< samples of the cells of several films; empty for a single one
};

}  // namespace etalon
