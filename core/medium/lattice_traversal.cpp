#include "core/medium/lattice_traversal.h"

namespace etalon {

LatticeTraversal::LatticeTraversal(const std::array<int, 3>& cells, double shift,
                                   const RaySegment& ray, double begin, double end)
    : here_(begin), end_(end) {
    if (!(begin < end)) return;
    const Vec3 entry = ray.point(begin);
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        const double d = ray.direction[axis], size = cells[k];
        const double cell = std::floor(entry[axis] * size - shift);
        index_[k] = static_cast<int>(cell);
        step_[k] = d > 0 ? 1 : -1;
        width_[k] = d == 0 ? infinity : 1 / (size * std::abs(d));
        const double plane = (cell + (d > 0 ? 1 : 0) + shift) / size;
        border_[k] = d == 0 ? infinity : (plane - ray.origin[axis]) / d;
    }
}

}  // namespace etalon
