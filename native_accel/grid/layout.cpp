#include "native_accel/grid/layout.h"

namespace etalon {
namespace {

constexpr int max_resolution = 1024;

/// The edge of the cubes of which `count` fill the box.
double cube_edge(const Vec3& size, double count) {
    std::array<double, 3> extents = {size.x, size.y, size.z};
    std::sort(extents.begin(), extents.end());
    double edge = std::cbrt(extents[0] * extents[1] * extents[2] / count);
    if (edge > extents[0]) edge = std::sqrt(extents[1] * extents[2] / count);
    if (edge > extents[1]) edge = extents[2] / count;
    return edge;
}

double half_area(const Vec3& size) {
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

Vec3f lanes_of(const Vec3& v) {
    return Vec3f(v);
}

}  // namespace

GridLayout::GridLayout(const Box3& box, double cell_count) {
    const Vec3 size = box.size();
    const double edge = cube_edge(size, std::max(cell_count, 1.0));
    low = Vec3(Vec3f(box.min));
    for (int k = 0; k < 3; ++k) {
        const double wanted = std::round(size[k] / edge);
        resolution[k] = static_cast<int>(std::clamp(wanted, 1.0, double(max_resolution)));
        cell_size[k] = static_cast<float>(size[k] / resolution[k]);
        cells_per_length[k] = 1 / cell_size[k];
    }
}

GridNode GridLayout::node(std::uint32_t first_cell) const {
    const Vec3 count(resolution[0], resolution[1], resolution[2]);
    return {lanes(lanes_of(low), 0),
            lanes(lanes_of(low + cell_size * count), 0),
            lanes(lanes_of(cell_size), 0),
            lanes(lanes_of(cells_per_length), 0),
            resolution,
            first_cell};
}

Box3 GridLayout::box_of(std::uint32_t flat_index) const {
    const int x = static_cast<int>(flat_index % resolution[0]);
    const int rows = static_cast<int>(flat_index / resolution[0]);
    const Vec3 corner = low + cell_size * Vec3(x, rows % resolution[1], rows / resolution[1]);
    return {corner, corner + cell_size};
}

double GridLayout::share_of_rays() const {
    const Vec3 count(resolution[0], resolution[1], resolution[2]);
    return half_area(cell_size) / half_area(cell_size * count);
}

}  // namespace etalon
