#pragma once

#include <span>
#include <vector>

#include "core/light/search_guide.h"
#include "core/numerics/vec.h"

namespace etalon {

/// A density over the unit square that is the same everywhere in a cell of a grid. Places are
/// chosen by inversion, first the row and then the cell in it, so that well distributed numbers
/// make well distributed places.
class PiecewiseConstant2D {
  public:
    PiecewiseConstant2D() = default;  ///< without cells

    /// In proportion to values of the cells, none of them negative, by rows.
    PiecewiseConstant2D(int width, int height, std::vector<double> values);

    bool empty() const { return cells_.empty(); }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Sum of the values that it was made from.
    double sum() const { return empty() ? 0 : row_sums_.back(); }

    struct Sample {
        Vec2 place;
        double density;
    };

    /// Chooses a place by numbers in [0, 1).
    Sample sample(const Vec2& uv) const;

    /// The density at a place of the unit square.
    double density(const Vec2& place) const;

  private:
    std::span<const double> sums_of_row(std::size_t row) const;

    int width_ = 0, height_ = 0;
    std::vector<double> cells_;      ///< densities, by rows
    std::vector<double> sums_;       ///< of each row, up to and with each cell
    std::vector<double> row_sums_;   ///< of rows, up to and with each
    SearchGuide guide_, row_guide_;  ///< of these
};

/// Values of a grid whose sides are powers of two, by rows.
struct CellValues {
    int width, height;
    std::vector<double> values;
};

/// Joins cells by fours, into ones with the sum of their values, while there are more than `enough`
/// and what places are chosen for grows no noisier than that: the second moment of the values over
/// their density, 1 at first, stays below `most_moment`. A table that caches hold is sampled in a
/// fraction of the time.
CellValues joined_cells(CellValues cells, std::size_t enough, double most_moment);

}  // namespace etalon
