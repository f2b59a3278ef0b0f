#include "native_accel/grid/cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace etalon {
namespace {

/// The cells a padded box touches, both ends included.
struct CellRange {
    CellRange(const Box3f& box, const GridShape& shape) {
        for (int k = 0; k < 3; ++k) {
            low[k] = shape.cell(box.min[k], k);
            high[k] = shape.cell(box.max[k], k);
        }
    }

    double count() const {
        return (high[0] - low[0] + 1.0) * (high[1] - low[1] + 1.0) * (high[2] - low[2] + 1.0);
    }

    template <class F>
    void for_each(const F& f) const {
        CellIndex c;
        for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) {
            for (c[1] = low[1]; c[1] <= high[1]; ++c[1]) {
                for (c[0] = low[0]; c[0] <= high[0]; ++c[0]) f(c);
            }
        }
    }

    CellIndex low, high;
};

double count_references(std::span<const BoundedPrimitive> primitives, const GridShape& shape) {
    return std::accumulate(primitives.begin(), primitives.end(), 0.0,
                           [&](double sum, const BoundedPrimitive& p) {
                               return sum + CellRange(p.box, shape).count();
                           });
}

/// The finest grid, starting from the aim, that large primitives do not fill with references.
GridShape choose_shape(std::span<const BoundedPrimitive> primitives, const Box3f& box,
                       const GridConfig& config) {
    const double limit = config.max_references * static_cast<double>(primitives.size());
    double cells = config.cells_per_primitive * static_cast<double>(primitives.size());
    while (true) {
        const GridShape shape(box, cells, config.max_resolution);
        if (shape.size() == 1 || count_references(primitives, shape) <= limit) return shape;
        cells /= 4;
    }
}

}  // namespace

GridShape::GridShape(const Box3f& box, double cell_count, int max_resolution) {
    origin = Vec3(box.min);
    const Vec3 size = Vec3(box.max) - origin;
    // Cubic cells of the volume's cell_count-th part (the padding keeps the volume above zero).
    const double edge = std::cbrt(size.x * size.y * size.z / cell_count);
    for (int k = 0; k < 3; ++k) {
        resolution[k] = static_cast<int>(std::clamp(size[k] / edge, 1.0, double(max_resolution)));
        cell_size[k] = size[k] / resolution[k];
    }
}

int GridShape::cell(double coordinate, int axis) const {
    const double position = (coordinate - origin[axis]) / cell_size[axis];
    return static_cast<int>(std::clamp(position, 0.0, resolution[axis] - 1.0));
}

GridCells::GridCells(std::span<const BoundedPrimitive> primitives, const GridConfig& config) {
    if (primitives.empty()) return;
    for (const BoundedPrimitive& p : primitives) box.extendBy(p.box);
    shape = choose_shape(primitives, box, config);
    offsets.assign(shape.size() + 1, 0);
    for (const BoundedPrimitive& p : primitives) {
        CellRange(p.box, shape).for_each([&](const CellIndex& c) { ++offsets[shape.flat(c)]; });
    }
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    ids.resize(offsets.back());
    // Filling from the back turns each cell's end into its begin, ids ascending within it.
    for (std::size_t i = primitives.size(); i-- > 0;) {
        CellRange(primitives[i].box, shape).for_each([&](const CellIndex& c) {
            ids[--offsets[shape.flat(c)]] = primitives[i].id;
        });
    }
}

}  // namespace etalon
