#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

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

/// How far the items of a scene reach. Some that reach far beyond all others, such as a triangle
/// with a corner at 1e23, would leave the others no room in normalized space: their boxes would be
/// nothing but padding. A few such outliers are always tested, like planes; more of them have a
/// tree of their own.
class ReachCounts {
  public:
    /// Limit of a scene without outliers.
    static constexpr double no_limit = std::numeric_limits<double>::max();

    /// Largest number of outliers that are always tested.
    static constexpr std::size_t few = 16;

    void add(double reach, bool is_instance = false) {
        if (reach > 0) add(binade_of(reach), is_instance ? Count{0, 1} : Count{1, 0});
    }

    void add(const ReachCounts& others) {
        for (const auto& [binade, count] : others.counts_) add(binade, count);
    }

    /// Returns the largest coordinate of items that are not outliers, or a number above that, but
    /// below those of outliers.
    double limit() const {
        Count near, far;
        for (const auto& [binade, count] : counts_) near += count;
        double limit = no_limit;
        for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
            far += counts_[i].second;
            near -= counts_[i].second;
            const std::uint64_t next = counts_[i + 1].first;
            if (counts_[i].first - next > far_beyond && are_outliers(far, near)) {
                limit = std::bit_cast<double>((next + 1) << 52);
            }
        }
        return limit;
    }

  private:
    struct Count {
        std::size_t all() const { return primitives + instances; }
        Count& operator+=(const Count& more) {
            primitives += more.primitives;
            instances += more.instances;
            return *this;
        }
        Count& operator-=(const Count& fewer) {
            primitives -= fewer.primitives;
            instances -= fewer.instances;
            return *this;
        }

        std::size_t primitives = 0, instances = 0;
    };

    /// Difference of the exponents of the reach of an outlier and that of all others. At this
    /// factor the padding of boxes is a thirtieth of the reach of the others.
    static constexpr std::uint64_t far_beyond = 14;

    /// Returns whether items that reach far beyond the others are outliers: not where most items
    /// do, since their tree is slower than normalized space, nor many instances, which have no
    /// such tree.
    static bool are_outliers(const Count& far, const Count& near) {
        return far.all() <= few || (far.instances <= few && far.all() <= near.all());
    }

    /// Returns the biased exponent of a number above 0.
    static std::uint64_t binade_of(double x) { return std::bit_cast<std::uint64_t>(x) >> 52; }

    void add(std::uint64_t binade, const Count& count) {
        auto at = counts_.begin();
        while (at != counts_.end() && at->first > binade) ++at;
        if (at == counts_.end() || at->first != binade) at = counts_.insert(at, {binade, {}});
        at->second += count;
    }

    std::vector<std::pair<std::uint64_t, Count>> counts_;  ///< by binade, in decreasing order
};

}  // namespace etalon
