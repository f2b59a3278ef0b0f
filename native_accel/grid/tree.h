// Nested grids: cells with many primitives are divided again (Jevans & Wyvill 1989, "Adaptive Voxel
// Subdivision for Ray Tracing").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "native_accel/grid/lanes.h"

namespace etalon {

using CellIndex = std::array<int, 3>;

/// A list of `count` items from `first` on, or a nested grid. Empty if the count is zero.
struct GridCell {
    static constexpr std::uint32_t grid = 0xFFFFFFFFU;

    bool is_grid() const { return count == grid; }

    std::uint32_t first = 0;  ///< index of the first item, or of the grid in GridTree::nodes
    std::uint32_t count = 0;
};

/// A box divided evenly along each axis, in normalized space. The plane between cells i - 1 and i
/// of an axis is low + i * cell_size.
struct GridNode {
    CellIndex resolution() const { return {last[0] + 1, last[1] + 1, last[2] + 1}; }

    Float4 low, high, cell_size, cells_per_length;
    Mask4 last;                ///< number of cells of an axis, minus one; 0 in the fourth lane
    Mask4 stride;              ///< index step between cells along an axis; 0 in the fourth lane
    std::uint32_t first_cell;  ///< index in GridTree::cells; x runs fastest, then y
};

/// A tree of nested grids. The lists of cells are compact: adjacent in one array (Lagae & Dutré
/// 2008, "Compact, Fast and Robust Grids for Ray Tracing").
struct GridTree {
    GridCell root;
    std::vector<GridNode> nodes;
    std::vector<GridCell> cells;
    std::vector<std::uint32_t> items;  ///< numbers of the items it was built from
};

}  // namespace etalon
