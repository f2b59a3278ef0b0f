#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// Returns two triangles for each cell of a grid of vertices that are numbered row by row; three
/// vertices for each. A cell is split from its corner of the lowest number to that of the highest,
/// and its triangles wind from columns to rows, as pbrt-v3's do. Empty for a single row or column.
inline std::vector<std::uint32_t> grid_corners(std::uint32_t columns, std::uint32_t rows) {
    std::vector<std::uint32_t> corners;
    if (columns < 2 || rows < 2) return corners;
    corners.reserve(std::size_t{6} * (columns - 1) * (rows - 1));
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            corners.insert(corners.end(), {a, b, d, a, d, c});
        }
    }
    return corners;
}

}  // namespace etalon
