// Traversal of one grid by a ray (Amanatides & Woo 1987), along all axes at once. The time at which
// the ray enters a cell is always computed from the cell's index, so that errors do not accumulate.
//
// Proof that nothing is lost: let t be where the ray hits a primitive or enters a box. On each axis
// the traversal is, at time t, in the cell whose time of entry is the last one <= t; it passes
// through those cells whatever happens on the other axes. That cell is where the ray is at t, up to
// the error of a time of entry. As a length, with u = 2^-24, |o| <= 3 and |plane| <= 1, so |plane -
// o| <= 4, that error is
//   22 u for the time itself: 4 u each for the difference from the origin, the reciprocal of the
//     direction, their product and the last sum, 2 u each for the pace, its product with the cell's
//     size and that with the index;
//   3 u for `high`, which is a rounded sum, and for cells_per_length, by which the start is found;
//   6.1 u for the ray, whose float origin and direction are off by 2.1 u and 4 u.
// Together 31.1 u, and 20 u for when a box is entered; everything within grid_padding of a cell is
// in the cell's list. The ends of a grid need no care: on each axis the first and the last cell
// have no end, and the traversal stops at a time that the caller gives.
#pragma once

#include "native_accel/grid/grid_ray.h"
#include "native_accel/grid/layout.h"

namespace etalon {

class GridTraversal {
  public:
    /// Starts where the ray is at time `t`. Cells are counted along the ray: from the high end if
    /// it runs backward.
    HWY_INLINE GridTraversal(const GridNode& node, const GridRay& ray, float t) {
        const Float4 near = select(ray.forward, node.low, node.high);
        entry_ = (near - ray.origin) * ray.reciprocal;
        pace_ = node.cell_size * ray.pace;
        last_ = to_float(node.last);
        const Float4 cells_per_time = node.cells_per_length * ray.speed;
        const Float4 passed = (broadcast(t) - entry_) * cells_per_time;
        const Mask4 start = truncated(min(max(passed, Float4{}), last_));
        next_ = entry_to(to_float(start) + 1.0F);
        index_ = to_float(start) + 2.0F;
        after_ = entry_to(index_);
        place(start, node, ray);
    }

    /// Returns the index of the cell in GridTree::cells.
    HWY_INLINE std::uint32_t cell() const { return cell_; }

    /// Returns the time at which the ray leaves the cell, in every lane; infinity in the last cell.
    HWY_INLINE Float4 exit() const { return min_of_lanes(next_); }

    /// Steps to the next cell. The data for the step after next is computed before it is known
    /// which axis that crosses, so that a step depends only on the one before.
    HWY_INLINE void advance(Float4 exit) {
        const Mask4 crossed = next_ <= exit;
        cell_ += delta_[bits(crossed) & 7];
        next_ = select(crossed, after_, next_);
        const Float4 index = index_ + 1.0F;
        after_ = select(crossed, entry_to(index), after_);
        index_ = select(crossed, index, index_);
    }

  private:
    /// Returns the times at which the cells with the given offsets from the first are entered.
    HWY_INLINE Float4 entry_to(Float4 index) const {
        const Float4 never = broadcast(std::numeric_limits<float>::infinity());
        return max(entry_ + index * pace_, keep(index > last_, never));
    }

    HWY_INLINE void place(Mask4 start, const GridNode& node, const GridRay& ray) {
        const Mask4 from_low = ray.forward ? start : node.last - start;
        const Mask4 passed = from_low * node.stride;
        cell_ = node.first_cell + static_cast<std::uint32_t>(passed[0] + passed[1] + passed[2]);
        const Mask4 step = ray.forward ? node.stride : -node.stride;
        const auto x = static_cast<std::uint32_t>(step[0]), y = static_cast<std::uint32_t>(step[1]),
                   z = static_cast<std::uint32_t>(step[2]);
        delta_ = {0, x, y, x + y, z, x + z, y + z, x + y + z};
    }

    Float4 entry_, pace_, last_;
    /// Times at which the next border of each axis, and the one after it, are crossed.
    Float4 next_, after_;
    Float4 index_;  ///< index of the cell that is entered at after_
    std::uint32_t cell_;
    std::array<std::uint32_t, 8> delta_;
};

}  // namespace etalon
