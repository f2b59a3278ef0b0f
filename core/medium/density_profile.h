#pragma once

#include <vector>

#include "core/medium/density_bounds.h"

namespace etalon {

/// The integral of a grid's density along a segment: exact but for roundings, as densities between
/// the borders of cells are cubic in the distance, for which Simpson's rule is exact.
class DensityProfile {
  public:
    /// `ray` is in the space of the grid's box, its distances in the world. Ends where the integral
    /// is `enough`. The grid must outlive the profile.
    void make(const DensityGrid& grid, const DensityBounds& bounds, const RaySegment& ray,
              double enough);

    /// The integral over all of the segment.
    double total() const { return knots_.empty() ? 0 : knots_.back().integral; }

    /// A point found by an integral.
    struct Point {
        double distance;
        double integral;        ///< up to the point
        double density_factor;  ///< its density over the one that was expected there
    };

    /// The point where the integral would have that value, below total(), if densities were linear
    /// between the borders of cells, and as large as they are on the whole there.
    Point find(double integral) const;

  private:
    struct Knot {
        double distance, integral;
        float density;
    };
    void add_cells(double begin, double end);

    const DensityGrid* grid_ = nullptr;
    RaySegment ray_{};
    std::vector<Knot> knots_;
};

}  // namespace etalon
