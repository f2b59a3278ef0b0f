#pragma once

#include <vector>

#include "core/medium/lattice_traversal.h"
#include "core/scene/physical_medium.h"

namespace etalon {

/// Bounds of a grid's densities in boxes of several cells, so that a ray's steps are as long as the
/// density near it allows.
class DensityBounds {
    struct DistanceRange {
        double begin, end;
    };
    static DistanceRange part_in_box(const RaySegment& segment);

  public:
    explicit DensityBounds(const DensityGrid& grid);

    /// Bounds of the density along an interval of a ray.
    struct Step {
        float least, most;
        double end;  ///< distance at which the step ends
    };

    /// Visits the boxes along a ray, in order.
    class Traversal {
      public:
        /// `segment` is in the space of the grid's box, with distances in world units.
        Traversal(const DensityBounds& bounds, const RaySegment& segment)
            : Traversal(bounds, segment, part_in_box(segment)) {}

        double begin() const { return begin_; }  ///< where the ray enters the grid's box

        /// Returns the next box; nothing at the end of the segment or of the grid's box.
        std::optional<Step> next();

      private:
        Traversal(const DensityBounds& bounds, const RaySegment& segment, const DistanceRange& part)
            : bounds_(bounds),
              begin_(part.begin),
              boxes_(bounds.size_, 0, segment, part.begin, part.end) {}

        const DensityBounds& bounds_;
        double begin_;
        LatticeTraversal boxes_;
    };

  private:
    struct Range {
        float least, most;
    };
    Range range_of(const DensityGrid& grid, const std::array<int, 3>& box) const;

    std::array<int, 3> size_{};
    std::vector<Range> ranges_;
};

}  // namespace etalon
