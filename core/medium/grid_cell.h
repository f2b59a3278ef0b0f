#pragma once

#include <array>
#include <cmath>

#include "core/scene/physical_medium.h"

namespace etalon {

/// The eight densities from which those within a cell are interpolated. The cells are those of the
/// lattice through the centres of the grid's cells.
class GridCell {
  public:
    /// `index` has the numbers of the grid's cell at the lower corner.
    GridCell(const DensityGrid& grid, const std::array<int, 3>& index) {
        const auto [nx, ny, nz] = grid.size;
        const auto [x, y, z] = index;
        const bool is_inner = x >= 0 && y >= 0 && z >= 0 && x + 1 < nx && y + 1 < ny && z + 1 < nz;
        for (int i = 0; i < 8; ++i) {
            const int cx = x + i % 2, cy = y + i / 2 % 2, cz = z + i / 4;
            const bool is_inside =
                is_inner || (cx >= 0 && cy >= 0 && cz >= 0 && cx < nx && cy < ny && cz < nz);
            const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(cz) * ny + cy;
            corners_[static_cast<std::size_t>(i)] =
                is_inside ? grid.densities[static_cast<std::size_t>(row * nx + cx)] : 0;
        }
    }

    /// Returns the density at a point of the unit cube.
    float at(float x, float y, float z) const {
        const auto line = [&](std::size_t i) { return lerp(x, corners_[i], corners_[i + 1]); };
        return lerp(z, lerp(y, line(0), line(2)), lerp(y, line(4), line(6)));
    }

  private:
    static float lerp(float t, float a, float b) { return a + t * (b - a); }

    std::array<float, 8> corners_;
};

/// Returns the density at a point of the grid's box.
inline float density_at(const DensityGrid& grid, const Vec3& point) {
    const double x = point.x * grid.size[0] - 0.5, y = point.y * grid.size[1] - 0.5,
                 z = point.z * grid.size[2] - 0.5;
    const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const GridCell cell(grid, {static_cast<int>(fx), static_cast<int>(fy), static_cast<int>(fz)});
    return cell.at(static_cast<float>(x - fx), static_cast<float>(y - fy),
                   static_cast<float>(z - fz));
}

}  // namespace etalon
