#pragma once

#include <array>
#include <limits>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the largest magnitude of a box's coordinates.
inline double reach_of(const Box3& box) {
    return std::max(max_abs(box.min), max_abs(box.max));
}

/// Returns whether the box is not empty and no coordinate of it is beyond `limit`.
inline bool is_bounded(const Box3& box, double limit) {
    return !box.isEmpty() && is_finite(box.min) && is_finite(box.max) && reach_of(box) <= limit;
}

/// The items of a scene that reach furthest. A few that reach far beyond all others, such as a
/// triangle with a corner at 1e23, would leave the others no room in normalized space: their boxes
/// would be nothing but padding. Such outliers are always tested, like planes.
class FurthestItems {
  public:
    /// Limit of a scene without outliers.
    static constexpr double no_limit = std::numeric_limits<double>::max();

    void add(double reach) {
        if (reach > reaches_.back()) insert(reach);
    }

    void add(const FurthestItems& others) {
        for (const double reach : others.reaches_) add(reach);
    }

    /// Returns the largest coordinate of items that are not outliers.
    double limit() const {
        for (std::size_t i = most_outliers; i > 0; --i) {
            const double next = reaches_[i];
            if (next > 0 && reaches_[i - 1] / far_beyond >= next) return next;
        }
        return no_limit;
    }

  private:
    /// Factor between the reach of an outlier and that of all others. At this factor the padding of
    /// boxes is a thirtieth of the reach of the others.
    static constexpr double far_beyond = 0x1p14;
    static constexpr std::size_t most_outliers = 16;

    void insert(double reach) {
        std::size_t i = reaches_.size() - 1;
        for (; i > 0 && reaches_[i - 1] < reach; --i) reaches_[i] = reaches_[i - 1];
        reaches_[i] = reach;
    }

    std::array<double, most_outliers + 1> reaches_{};  ///< in decreasing order
};

}  // namespace etalon
