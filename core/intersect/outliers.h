#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Which items are outliers: those that leave the others no room, or also a few whose tests are
/// estimated to cost less than the padding that boxes need because of them.
enum class OutlierRule { no_room, cost };

/// How far the items of a scene reach from its middle, and how large they are. Boxes are padded in
/// proportion to the size of normalized space, so that some items that reach far beyond the others,
/// such as a large ground, make the boxes of a fine mesh much larger than its triangles, or leave
/// them no room at all. A few such outliers are always tested, like planes; more of them have a
/// tree of their own.
class ReachCounts {
  public:
    /// Largest number of outliers that are always tested.
    static constexpr std::size_t few = 16;

    /// Adds an item. `reach` is its largest distance from the middle, 0 or more and possibly
    /// infinite, and `size` the longest edge of its box.
    void add(double reach, double size, bool is_instance);
    void add(const ReachCounts& others);

    /// Returns the largest reach of items that are not outliers, or a number above that, but below
    /// those of outliers; infinity where there are none.
    double limit(OutlierRule rule) const;

  private:
    struct Count {
        std::size_t all() const { return primitives + instances; }
        Count& operator+=(const Count& more);
        Count& operator-=(const Count& fewer);

        std::size_t primitives = 0, instances = 0;
        std::uint64_t binades = 0;  ///< sum of those of the sizes of primitives
    };

    void add(std::uint64_t binade, const Count& count);
    static bool leave_no_room(const Count& far, std::uint64_t binades_between);
    static double cost(const Count& far, const Count& near, std::uint64_t binade_of_near);

    std::vector<std::pair<std::uint64_t, Count>> counts_;  ///< by binade, in decreasing order
};

}  // namespace etalon
