#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace etalon {

/// Cost of traversal and of tests, relative to a step from one cell to the next.
struct GridCost {
    std::uint32_t pack_size;  ///< number of items that are tested at once
    double pack;              ///< cost of testing them
    double open;              ///< cost of opening a cell that is not empty
    double enter;             ///< cost of starting the traversal of a grid

    double list(std::uint32_t items) const {
        if (items == 0) return 0;
        const std::uint32_t packs = (items + pack_size - 1) / pack_size;
        return open + pack * packs;
    }

    /// Returns the cost of a cell that may become a grid. A ray through a good grid visits about as
    /// many cells as lie along an edge, the cube root of their number.
    double cell(std::uint32_t items) const {
        if (items <= pack_size) return list(items);
        return std::min(list(items), enter + 2 * std::cbrt(items));
    }

    /// Returns whether a list is so short that no grid could be better.
    bool is_short(std::uint32_t items) const { return list(items) <= enter + 2; }
};

}  // namespace etalon
