#pragma once

#include <array>
#include <optional>

#include "core/medium/ray_segment.h"

namespace etalon {

/// Visits the cells of a lattice along an interval of a ray, in order (Amanatides & Woo 1987).
class LatticeTraversal {
  public:
    struct Cell {
        std::array<int, 3> index;
        double end;  ///< distance at which the ray leaves it
    };

    /// Planes are at (i + shift) / cells along each axis.
    LatticeTraversal(const std::array<int, 3>& cells, double shift, const RaySegment& ray,
                     double begin, double end);

    /// Returns the next cell; nothing at the end of the interval.
    std::optional<Cell> next() {
        if (!(here_ < end_)) return std::nullopt;
        const std::size_t axis = border_[0] < border_[1] ? (border_[0] < border_[2] ? 0 : 2)
                                                         : (border_[1] < border_[2] ? 1 : 2);
        here_ = std::max(here_, std::min(border_[axis], end_));
        const Cell cell{index_, here_};
        index_[axis] += step_[axis];
        border_[axis] += width_[axis];
        return cell;
    }

  private:
    double here_, end_;
    std::array<int, 3> index_{}, step_{};
    std::array<double, 3> border_{}, width_{};  ///< distance of the next borders, and between
};

}  // namespace etalon
