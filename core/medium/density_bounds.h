#pragma once

#include <vector>

#include "core/medium/lattice_walk.h"
#include "core/scene/physical_medium.h"

namespace etalon {

/// Bounds of a grid's densities in boxes of several cells each, so that a ray takes steps as long
/// as the density near it allows.
class DensityBounds {
    struct DistanceRange {
        double begin, end;
    };
    static DistanceRange part_in_box(const RaySegment& segment);

  public:
    explicit DensityBounds(const DensityGrid& grid);

    /// Bounds of the density along a part of a ray.
    struct Step {
        float least, most;
        double end;  ///< distance at which the step ends
    };

    /// The boxes along a ray, in order.
    class Walk {
      public:
        /// `segment` is in the space of the grid's box, its distances in the world.
        Walk(const DensityBounds& bounds, const RaySegment& segment)
            : Walk(bounds, segment, part_in_box(segment)) {}

        double begin() const { return begin_; }  ///< where the ray enters the grid's box

        /// The next box; nothing at the end of the segment or of the grid's box.
        std::optional<Step> next();

      private:
        Walk(const DensityBounds& bounds, const RaySegment& segment, const DistanceRange& part)
            : bounds_(bounds),
              begin_(part.begin),
              boxes_(bounds.size_, 0, segment, part.begin, part.end) {}

        const DensityBounds& bounds_;
        double begin_;
        LatticeWalk boxes_;
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
