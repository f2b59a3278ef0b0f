#pragma once

#include "native_accel/grid/tree.h"

namespace etalon {

/// Margin by which the list of a cell reaches beyond the cell, so that GridTraversal loses nothing,
/// not even a box that the ray enters at a time that is itself off by 20 u (see Slabs). 9 u of it
/// are for the roundings of GridLayout::cells_of. It does not rely on the padding of the boxes.
inline constexpr float grid_padding = 64 * 0x1p-24F;

/// Returns half the surface area of a box of that size.
inline double half_area(const Vec3& size) {
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// A range of cells, both ends included.
struct CellRange {
    bool is_one_cell() const { return low == high; }
    double size() const {
        return (high[0] - low[0] + 1.0) * (high[1] - low[1] + 1.0) * (high[2] - low[2] + 1.0);
    }
    CellIndex low, high;
};

/// Shape of the cells of a box.
enum class Cut {
    cubes,         ///< as nearly as the proportions allow; axes shorter than a cell are not divided
    equal_counts,  ///< as many cells along each axis, for items as long as the box or as thin
};

/// Cells into which a box is divided.
struct GridLayout {
    GridLayout(const Box3& box, double cell_count, Cut cut = Cut::cubes);  ///< about `cell_count`

    GridNode node(std::uint32_t first_cell) const;

    /// Returns the cells that a box, padded, overlaps. Outside of the grid these are cells at the
    /// border.
    CellRange cells_of(const Box3f& box) const {
        const Float4 last = to_float(count_) - 1.0F;
        const auto at = [&](Float4 place) {
            const Float4 passed = (place - low_) * cells_per_length_;
            const Mask4 c = truncated(min(max(passed, Float4{}), last));
            return CellIndex{c[0], c[1], c[2]};
        };
        return {at(lanes(box.min, 0) - grid_padding), at(lanes(box.max, 0) + grid_padding)};
    }

    std::uint32_t flat(const CellIndex& c) const {
        return static_cast<std::uint32_t>((c[2] * count_[1] + c[1]) * count_[0] + c[0]);
    }

    Vec3 centre(const CellIndex& c) const {
        return low() + cell_size() * Vec3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
    }

    /// Returns the box of a cell.
    Box3 box_of(std::uint32_t flat_index) const;

    Vec3 cell_size() const { return {cell_size_[0], cell_size_[1], cell_size_[2]}; }

    std::size_t size() const { return static_cast<std::size_t>(count_[0]) * count_[1] * count_[2]; }

    /// Returns the approximate probability that a ray which crosses the box also crosses a given
    /// cell; the second function, the mean of it for rays along each axis.
    double share_of_rays() const;
    double share_along_axes() const;

  private:
    Vec3 low() const { return {low_[0], low_[1], low_[2]}; }
    Vec3 count() const { return Vec3(count_[0], count_[1], count_[2]); }

    Float4 low_{}, cell_size_{}, cells_per_length_{};
    Mask4 count_{1, 1, 1, 1};
};

}  // namespace etalon
