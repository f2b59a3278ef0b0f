#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/medium/ray_segment.h"
#include "core/scene/physical_medium.h"

namespace etalon {

/// Bounds of a grid's densities in boxes of several cells each, so that a ray takes steps as long
/// as the density near it allows.
class DensityBounds {
  public:
    explicit DensityBounds(const DensityGrid& grid);

    /// Bounds of the density along a part of a ray.
    struct Step {
        float least, most;
        double end;  ///< distance at which the step ends
    };

    /// The boxes along a ray, in order (Amanatides & Woo 1987).
    class Walk {
      public:
        /// `segment` is in the space of the grid's box, its distances in the world.
        Walk(const DensityBounds& bounds, const RaySegment& segment);

        double begin() const { return begin_; }  ///< where the ray enters the grid's box

        /// The next box; nothing at the end of the segment or of the grid's box.
        std::optional<Step> next();

      private:
        void enter(const RaySegment& segment);

        const DensityBounds& bounds_;
        double begin_ = 0, end_, here_ = 0;
        std::array<int, 3> box_{}, step_{};
        std::array<double, 3> border_{}, width_{};  ///< distance of the next borders, and between
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
