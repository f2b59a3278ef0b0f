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
                               return sum + CellRange(p.box(), shape).count();
                           });
}

struct Candidate {
    GridShape shape;
    double references;
};

/// Of as many cubes and boxes, those that the primitives are in fewer of.
Candidate better_cut(std::span<const BoundedPrimitive> primitives, const Box3f& box, double cells,
                     int max_resolution) {
    Candidate best{{}, infinity};
    for (const Cut cut : {Cut::cubes, Cut::alike}) {
        const GridShape shape(box, cut, cells, max_resolution);
        const double references = count_references(primitives, shape);
        if (references < best.references) best = {shape, references};
    }
    return best;
}

/// The finest grid, starting from the aim, that large primitives do not fill with references.
GridShape choose_shape(std::span<const BoundedPrimitive> primitives, const Box3f& box,
                       const GridConfig& config) {
    const double limit = config.max_references * static_cast<double>(primitives.size());
    double cells = config.cells_per_primitive * static_cast<double>(primitives.size());
    while (true) {
        const Candidate c = better_cut(primitives, box, cells, config.max_resolution);
        if (c.shape.size() == 1 || c.references <= limit) return c.shape;
        cells /= 4;
    }
}

}  // namespace

GridShape::GridShape(const Box3f& box, Cut cut, double cell_count, int max_resolution) {
    origin = Vec3(box.min);
    const Vec3 size = Vec3(box.max) - origin;
    const double per_axis = std::cbrt(cell_count);
    // The padding keeps the volume above zero.
    const double cube = std::cbrt(size.x * size.y * size.z) / per_axis;
    for (int k = 0; k < 3; ++k) {
        const double wanted = cut == Cut::cubes ? size[k] / cube : per_axis;
        resolution[k] = static_cast<int>(std::clamp(wanted, 1.0, double(max_resolution)));
        cell_size[k] = size[k] / resolution[k];
    }
}

int GridShape::cell(double coordinate, int axis) const {
    const double position = (coordinate - origin[axis]) / cell_size[axis];
    return static_cast<int>(std::clamp(position, 0.0, resolution[axis] - 1.0));
}

GridCells::GridCells(std::span<const BoundedPrimitive> primitives, const GridConfig& config) {
    if (primitives.empty()) return;
    for (const BoundedPrimitive& p : primitives) box.extendBy(p.box());
    shape = choose_shape(primitives, box, config);
    offsets.assign(shape.size() + 1, 0);
    for (const BoundedPrimitive& p : primitives) {
        CellRange(p.box(), shape).for_each([&](const CellIndex& c) { ++offsets[shape.flat(c)]; });
    }
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    ids.resize(offsets.back());
    // Filling from the back turns each cell's end into its begin, ids ascending within it.
    for (std::size_t i = primitives.size(); i-- > 0;) {
        CellRange(primitives[i].box(), shape).for_each([&](const CellIndex& c) {
            ids[--offsets[shape.flat(c)]] = primitives[i].id;
        });
    }
}

}  // namespace etalon
