#pragma once

#include "native_accel/grid/tree.h"

namespace etalon {

/// How a box is cut into cells.
struct GridLayout {
    /// About so many cells, as near to cubes as the box's proportions allow; an axis along which
    /// the box is thinner than a cell is not cut.
    GridLayout(const Box3& box, double cell_count);

    GridNode node(std::uint32_t first_cell) const;

    /// The cell a coordinate lies in, clamped into the grid.
    int cell(double coordinate, int axis) const {
        const double position = (coordinate - low[axis]) * cells_per_length[axis];
        return static_cast<int>(std::clamp(position, 0.0, resolution[axis] - 1.0));
    }

    std::uint32_t flat(const CellIndex& c) const {
        return static_cast<std::uint32_t>((c[2] * resolution[1] + c[1]) * resolution[0] + c[0]);
    }

    Vec3 centre(const CellIndex& c) const {
        return low + cell_size * Vec3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
    }

    /// The box of a cell of that number.
    Box3 box_of(std::uint32_t flat_index) const;

    std::size_t size() const {
        return static_cast<std::size_t>(resolution[0]) * resolution[1] * resolution[2];
    }

    /// Of the rays that cross the box, about how many cross a certain cell.
    double share_of_rays() const;

    Vec3 low, cell_size, cells_per_length;
    CellIndex resolution;
};

}  // namespace etalon
