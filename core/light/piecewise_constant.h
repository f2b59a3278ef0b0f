#pragma once

#include <span>
#include <vector>

#include "core/light/search_guide.h"
#include "core/numerics/vec.h"

namespace etalon {

/// A density over the unit square that is constant in each cell of a grid. Points are sampled by
/// inversion, first the row and then the cell in it, so that well distributed numbers give well
/// distributed points.
class PiecewiseConstant2D {
  public:
    PiecewiseConstant2D() = default;  ///< without cells

    /// Makes a density in proportion to values of the cells, which must not be negative, by rows.
    PiecewiseConstant2D(int width, int height, std::vector<double> values);

    bool empty() const { return cells_.empty(); }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Returns the sum of the values from which it was made.
    double sum() const { return empty() ? 0 : row_sums_.back(); }

    struct Sample {
        Vec2 place;
        double density;
    };

    /// Samples a point with numbers in [0, 1).
    Sample sample(const Vec2& uv) const;

    /// Returns the density at a point of the unit square.
    double density(const Vec2& place) const;

  private:
    std::span<const double> sums_of_row(std::size_t row) const;

    int width_ = 0, height_ = 0;
    std::vector<double> cells_;      ///< densities, by rows
    std::vector<double> sums_;       ///< prefix sums in each row, up to and including each cell
    std::vector<double> row_sums_;   ///< prefix sums of the rows
    SearchGuide guide_, row_guide_;  ///< for searches in these
};

/// Values of a grid whose sides are powers of two, by rows.
struct CellValues {
    int width, height;
    std::vector<double> values;
};

/// Joins cells in groups of four, each with the sum of their values, while there are more than
/// `enough` and the noise of samples stays below a limit: the second moment of the values over
/// their density, 1 at first, must stay below `most_moment`. A table that fits the caches is
/// sampled in a fraction of the time.
CellValues joined_cells(CellValues cells, std::size_t enough, double most_moment);

}  // namespace etalon
