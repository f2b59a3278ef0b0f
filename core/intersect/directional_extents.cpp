#include "core/intersect/directional_extents.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/directional_extents.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

#ifndef ETALON_DIRECTIONAL_EXTENTS_ONCE
#define ETALON_DIRECTIONAL_EXTENTS_ONCE
namespace etalon {
namespace {

/// The directions of the grid. On the face of each axis that axis is 1, and the next two axes count
/// the corners of cells from -1 to 1. Each is followed by its opposite.
struct Grid {
    static constexpr auto steps = DirectionalExtents::steps;

    static constexpr std::size_t index(std::size_t axis, std::size_t next, std::size_t last) {
        return 2 * ((axis * steps + next) * steps + last);
    }

    Grid() {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < steps; ++i) {
                for (std::size_t j = 0; j < steps; ++j) {
                    const std::size_t to = index(axis, i, j);
                    set_pair(axes[axis], to, 1);
                    set_pair(axes[(axis + 1) % 3], to, corner(i));
                    set_pair(axes[(axis + 2) % 3], to, corner(j));
                    lengths[to] = lengths[to + 1] = std::hypot(1, corner(i), corner(j));
                }
            }
        }
    }

    alignas(64) std::array<DirectionalExtents::Values, 3> axes{};
    alignas(64) DirectionalExtents::Values lengths{};

  private:
    static double corner(std::size_t i) {
        return 2 * static_cast<double>(i) / DirectionalExtents::cells - 1;
    }
    static void set_pair(DirectionalExtents::Values& values, std::size_t to, double value) {
        values[to] = value;
        values[to + 1] = -value;
    }
};

const Grid grid;

}  // namespace
}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void extend(DirectionalExtents::Values& extents, const Vec3& centre, double radius) {
    const DoubleTag tag;
    const auto [x, y, z] = broadcast(centre);
    for (std::size_t i = 0; i < extents.size(); i += hn::Lanes(tag)) {
        const auto load = [&](const DirectionalExtents::Values& values)
                              HWY_ATTR { return hn::Load(tag, &values[i]); };
        Doubles extent = load(grid.lengths) * broadcast(radius);
        extent = hn::MulAdd(load(grid.axes[0]), x, extent);
        extent = hn::MulAdd(load(grid.axes[1]), y, extent);
        extent = hn::MulAdd(load(grid.axes[2]), z, extent);
        hn::Store(hn::Max(extent, load(extents)), tag, &extents[i]);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(extend);

namespace {

/// Numbers of two opposite directions.
using Pair = double __attribute__((vector_size(16)));

/// The cell of a coordinate in [-1, 1], and where in it that is, in [0, 1].
struct Cell {
    explicit Cell(double x) {
        constexpr auto cells = static_cast<int>(DirectionalExtents::cells);
        const double place = (x + 1) * (cells / 2.0);
        const int cell = std::min(static_cast<int>(place), cells - 1);
        index = static_cast<std::size_t>(cell);
        part = place - cell;
    }

    Pair mean(const Pair& low, const Pair& high) const { return (1 - part) * low + part * high; }

    std::size_t index;
    double part;
};

}  // namespace

void DirectionalExtents::extend_by(const Vec3& centre, double radius) {
    HWY_DYNAMIC_DISPATCH(extend)(extents_, centre, radius);
    largest_ = std::max(largest_, max_abs(centre) + radius);
}

/// The extent is convex and homogeneous in the direction, so for a direction that is a weighted
/// mean of others it is at most the weighted mean of theirs. With u = 2^-53, a direction on the
/// cube, and the largest coordinate L, no extent is above 3 L. Then the direction's place in its
/// cell is off by 5 u for each of two axes, which changes the extent by 10 u L, those at the
/// corners are off by 12 u L, and the mean by 27 u L.
DirectionalExtents::Extent DirectionalExtents::extent(const Vec3& direction) const {
    const int axis = dominant_axis(direction);
    const double size = direction[axis];
    if (size == 0) return {0, 0};
    const Cell next(direction[(axis + 1) % 3] / size), last(direction[(axis + 2) % 3] / size);
    const auto at = [&](std::size_t i, std::size_t j) {
        const std::size_t first =
            Grid::index(static_cast<std::size_t>(axis), next.index + i, last.index + j);
        return Pair{extents_[first], extents_[first + 1]};
    };
    const Pair mean = next.mean(last.mean(at(0, 0), at(0, 1)), last.mean(at(1, 0), at(1, 1)));
    const Pair extent = std::abs(size) * (mean + 0x1p-47 * largest_);
    const bool is_opposite = size < 0;
    return {extent[is_opposite], extent[!is_opposite]};
}

}  // namespace etalon
#endif
