// A ray's way through one grid (Amanatides & Woo 1987), along all axes at once. When the ray enters
// the cells of an axis is always computed from their index, so that errors do not add up.
//
// That no hit is lost: let t be where the ray hits a primitive. On each axis the walk is, at time
// t, in the cell whose time of entry is the last one <= t; the walk passes through those cells
// whatever happens on the other axes. That cell is where the hit is but for the error of a time of
// entry, which as a length, with u = 2^-24, |o| <= 3 and |plane| <= 1, so |plane - o| <= 4, is
//   22 u for the time itself: 4 u each for the difference from the origin, the reciprocal of the
//     direction, their product and the last sum, 2 u each for the pace, its product with the cell's
//     size and that with the index;
//   3 u for `high`, which is a rounded sum, and for cells_per_length, by which the start is found;
//   6.1 u for the ray, whose float origin and direction are off by 2.1 u and 4 u.
// Together 31.1 u; what comes within grid_padding of a cell is in the cell's list. The ends of
// a grid need no care: on each axis the first and the last cell have no end, and the walk stops at
// a time that is its caller's.
#pragma once

#include "native_accel/grid/layout.h"
#include "native_accel/grid/ray.h"

namespace etalon {

class GridWalk {
  public:
    /// From where the ray is at time `t`. Cells are counted along the ray: from the high end where
    /// it runs backward.
    GridWalk(const GridNode& node, const GridRay& ray, float t) {
        const Float4 near = select(ray.forward, node.low, node.high);
        entry_ = (near - ray.origin) * ray.reciprocal;
        pace_ = node.cell_size * ray.pace;
        const Float4 cells_per_time = node.cells_per_length * ray.speed;
        const auto [rx, ry, rz] = node.resolution;
        cells_ = to_float(Mask4{rx, ry, rz, 1});
        const Float4 passed = (broadcast(t) - entry_) * cells_per_time;
        const Mask4 start = truncated(min(max(passed, Float4{}), cells_ - 1.0F));
        index_ = to_float(start) + 1.0F;
        next_ = entry_to(index_);
        after_ = entry_to(index_ + 1.0F);
        place(start, node, ray);
    }

    /// Into GridTree::cells.
    std::uint32_t cell() const { return cell_; }

    /// When the ray leaves the cell, in every lane; infinity in the last one.
    Float4 exit() const { return min_of_lanes(next_); }

    void advance(Float4 exit) {
        const Mask4 crossed = next_ <= exit;
        cell_ += delta_[bits(crossed) & 7];
        index_ += keep(crossed, broadcast(1.0F));
        next_ = select(crossed, after_, next_);
        after_ = entry_to(index_ + 1.0F);
    }

  private:
    /// When the cells of so many places after the first are entered.
    Float4 entry_to(Float4 index) const {
        const Float4 never = broadcast(std::numeric_limits<float>::infinity());
        return max(entry_ + index * pace_, keep(index >= cells_, never));
    }

    void place(Mask4 start, const GridNode& node, const GridRay& ray) {
        const auto [rx, ry, rz] = node.resolution;
        const Mask4 last = Mask4{rx, ry, rz, 1} - 1;
        const Mask4 c = (ray.forward & start) | (~ray.forward & (last - start));
        const int plane = rx * ry;
        const auto step = [&](int k, int size) {
            return static_cast<std::uint32_t>(ray.forward[k] != 0 ? size : -size);
        };
        const std::uint32_t x = step(0, 1), y = step(1, rx), z = step(2, plane);
        cell_ = node.first_cell + static_cast<std::uint32_t>(c[0] + c[1] * rx + c[2] * plane);
        delta_ = {0, x, y, x + y, z, x + z, y + z, x + y + z};
    }

    Float4 entry_, pace_, cells_, index_, next_, after_;
    std::uint32_t cell_;
    std::array<std::uint32_t, 8> delta_;
};

}  // namespace etalon
