#pragma once

#include <array>
#include <cstddef>

#include "core/numerics/vec.h"

namespace etalon {

/// The support function of a set of points, for the directions of a grid, which is a discrete
/// oriented polytope (Klosowski et al. 1998). For other directions it is bounded from above.
class DirectionalExtents {
  public:
    DirectionalExtents() { extents_.fill(-infinity); }

    /// Extends the set by a ball, or a point.
    void extend_by(const Vec3& centre, double radius = 0);

    /// Largest products of a direction and of its opposite with any of the points, or more.
    struct Extent {
        double along, against;
    };

    /// Returns bounds for a finite direction. They exceed the extents of a ball about the origin by
    /// at most a sixteenth. No product of a direction and a point may be below the range of double.
    Extent extent(const Vec3& direction) const;

    /// Cells along each edge of the faces of a cube, to whose corners the directions point.
    static constexpr std::size_t cells = 4, steps = cells + 1;

    /// Values of pairs of opposite directions, padded to whole vectors.
    using Values = std::array<double, (3 * steps * steps * 2 + 7) / 8 * 8>;

  private:
    alignas(64) Values extents_;
    double largest_ = 0;  ///< magnitude of a coordinate of any point
};

}  // namespace etalon
