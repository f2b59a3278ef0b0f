#pragma once

#include <vector>

#include "core/medium/density_bounds.h"

namespace etalon {

/// The integral of a grid's density along a segment. It is exact up to roundings: between the
/// borders of cells densities are cubic in the distance, for which Simpson's rule is exact.
class DensityProfile {
  public:
    /// `ray` is in the space of the grid's box, with distances in world units. Stops where the
    /// integral reaches `enough`. The grid must outlive the profile.
    void make(const DensityGrid& grid, const DensityBounds& bounds, const RaySegment& ray,
              double enough);

    /// Returns the integral over the whole segment.
    double total() const { return knots_.empty() ? 0 : knots_.back().integral; }

    /// A point found by its integral.
    struct Point {
        double distance;
        double integral;        ///< up to the point
        double density_factor;  ///< its density over the one that was expected there
    };

    /// Returns the point at which the integral would have that value, below total(), if densities
    /// were linear between the borders of cells, with the same integrals.
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
