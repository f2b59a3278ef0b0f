// The cells of a uniform grid and what is in them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/intersect/bounded.h"

namespace etalon {

using CellIndex = std::array<int, 3>;

struct GridConfig {
    double cells_per_primitive = 4;  ///< aimed at
    double max_references = 12;  ///< per primitive, on average: a coarser grid is taken above it
    int max_resolution = 1024;   ///< cells along one axis
};

/// What a box is cut into: cubes, or boxes of its own proportions. The second suits what was
/// stretched as a whole.
enum class Cut { cubes, alike };

/// Which cells there are: a box cut evenly along each axis. All in the accelerator's frame.
struct GridShape {
    GridShape() = default;
    GridShape(const Box3f& box, Cut cut, double cell_count, int max_resolution);

    /// The cell a coordinate lies in, clamped into the grid.
    int cell(double coordinate, int axis) const;

    /// The plane between cells `index` - 1 and `index` of an axis.
    double plane(int index, int axis) const { return origin[axis] + index * cell_size[axis]; }

    std::size_t flat(const CellIndex& c) const {
        return (static_cast<std::size_t>(c[2]) * resolution[1] + c[1]) * resolution[0] + c[0];
    }

    std::size_t size() const {
        return static_cast<std::size_t>(resolution[0]) * resolution[1] * resolution[2];
    }

    CellIndex resolution{1, 1, 1};
    Vec3 origin{0}, cell_size{0};
};

/// Compact lists (Lagae & Dutré 2008, "Compact, Fast and Robust Grids for Ray Tracing"): one offset
/// a cell, one id a reference.
struct GridCells {
    GridCells() = default;
    GridCells(std::span<const BoundedPrimitive> primitives, const GridConfig& config);

    std::span<const std::uint32_t> in(const CellIndex& c) const {
        const std::size_t i = shape.flat(c);
        return {ids.data() + offsets[i], ids.data() + offsets[i + 1]};
    }

    Box3f box;
    GridShape shape;
    std::vector<std::uint32_t> offsets, ids;
};

}  // namespace etalon
