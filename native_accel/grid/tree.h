// Grids in grids: cells with many primitives in them are cut again (Jevans & Wyvill 1989, "Adaptive
// Voxel Subdivision for Ray Tracing").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "native_accel/grid/lanes.h"

namespace etalon {

using CellIndex = std::array<int, 3>;

/// `count` items from `first` on, or a grid of its own. No items where the count is zero.
struct GridCell {
    static constexpr std::uint32_t grid = 0xFFFFFFFFU;

    bool is_grid() const { return count == grid; }

    std::uint32_t first = 0;  ///< into the items, or GridTree::nodes
    std::uint32_t count = 0;
};

/// A box cut evenly along each axis, in the accelerator's frame. Between cells i - 1 and i of an
/// axis is the plane low + i * cell_size.
struct GridNode {
    CellIndex resolution() const { return {last[0] + 1, last[1] + 1, last[2] + 1}; }

    Float4 low, high, cell_size, cells_per_length;
    Mask4 last;                ///< cells of an axis, less one; 0 in the fourth lane
    Mask4 stride;              ///< from a cell to the next along an axis; 0 in the fourth lane
    std::uint32_t first_cell;  ///< into GridTree::cells; x runs fastest, then y
};

/// The lists of a cell are compact: neighbours in one array (Lagae & Dutré 2008, "Compact, Fast and
/// Robust Grids for Ray Tracing").
struct GridTree {
    GridCell root;
    std::vector<GridNode> nodes;
    std::vector<GridCell> cells;
    std::vector<std::uint32_t> items;  ///< numbers of what was built from
};

}  // namespace etalon
