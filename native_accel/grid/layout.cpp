#include "native_accel/grid/layout.h"

namespace etalon {
namespace {

constexpr int max_resolution = 1024;

/// Returns the edge of cubes of which `count` fill the box.
double cube_edge(const Vec3& size, double count) {
    std::array<double, 3> extents = {size.x, size.y, size.z};
    std::sort(extents.begin(), extents.end());
    double edge = std::cbrt(extents[0] * extents[1] * extents[2] / count);
    if (edge > extents[0]) edge = std::sqrt(extents[1] * extents[2] / count);
    if (edge > extents[1]) edge = extents[2] / count;
    return edge;
}

}  // namespace

GridLayout::GridLayout(const Box3& box, double cell_count, Cut cut)
    : low_(lanes(Vec3f(box.min), 0)) {
    const Vec3 size = box.size();
    const double count = std::max(cell_count, 1.0), edge = cube_edge(size, count);
    for (int k = 0; k < 3; ++k) {
        const double wanted = std::round(cut == Cut::cubes ? size[k] / edge : std::cbrt(count));
        count_[k] = static_cast<int>(std::clamp(wanted, 1.0, double(max_resolution)));
        cell_size_[k] = static_cast<float>(size[k] / count_[k]);
        cells_per_length_[k] = 1 / cell_size_[k];
    }
}

GridNode GridLayout::node(std::uint32_t first_cell) const {
    const Float4 high = lanes(Vec3f(low() + cell_size() * count()), 0);
    const Mask4 stride{1, count_[0], count_[0] * count_[1], 0};
    return {low_, high, cell_size_, cells_per_length_, count_ - 1, stride, first_cell};
}

Box3 GridLayout::box_of(std::uint32_t flat_index) const {
    const int x = static_cast<int>(flat_index % count_[0]);
    const int row = static_cast<int>(flat_index / count_[0]);
    const int y = row % count_[1], z = row / count_[1];
    const Vec3 corner = low() + cell_size() * Vec3(x, y, z);
    return {corner, corner + cell_size()};
}

double GridLayout::share_of_rays() const {
    return half_area(cell_size()) / half_area(cell_size() * count());
}

double GridLayout::share_along_axes() const {
    const Vec3 n = count();
    return (1 / (n.x * n.y) + 1 / (n.y * n.z) + 1 / (n.z * n.x)) / 3;
}

}  // namespace etalon
