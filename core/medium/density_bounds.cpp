#include "core/medium/density_bounds.h"

namespace etalon {
namespace {

/// Number of cells along each side of a box, chosen by measurement, and of boxes along an axis.
constexpr int cells_in_box = 4, most_boxes = 128;

}  // namespace

DensityBounds::DensityBounds(const DensityGrid& grid) {
    for (std::size_t k = 0; k < 3; ++k) {
        size_[k] = std::clamp((grid.size[k] + cells_in_box - 1) / cells_in_box, 1, most_boxes);
    }
    for (int z = 0; z < size_[2]; ++z) {
        for (int y = 0; y < size_[1]; ++y) {
            for (int x = 0; x < size_[0]; ++x) ranges_.push_back(range_of(grid, {x, y, z}));
        }
    }
}

/// Returns bounds of the density in a box, from all cells that contribute to its points.
DensityBounds::Range DensityBounds::range_of(const DensityGrid& grid,
                                             const std::array<int, 3>& box) const {
    std::array<int, 3> first{}, last{};
    bool leaves = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const double cells = static_cast<double>(grid.size[k]) / size_[k];
        first[k] = static_cast<int>(std::floor(box[k] * cells - 0.5));
        last[k] = static_cast<int>(std::floor((box[k] + 1) * cells - 0.5)) + 1;
        leaves = leaves || first[k] < 0 || last[k] >= grid.size[k];
        first[k] = std::max(first[k], 0);
        last[k] = std::min(last[k], grid.size[k] - 1);
    }
    Range range{leaves ? 0 : std::numeric_limits<float>::infinity(), 0};
    for (int z = first[2]; z <= last[2]; ++z) {
        for (int y = first[1]; y <= last[1]; ++y) {
            const std::size_t row = (static_cast<std::size_t>(z) * grid.size[1] + y) * grid.size[0];
            for (int x = first[0]; x <= last[0]; ++x) {
                range.least = std::min(range.least, grid.densities[row + x]);
                range.most = std::max(range.most, grid.densities[row + x]);
            }
        }
    }
    return range;
}

/// Returns the part of a segment that lies in the grid's box, possibly none.
DensityBounds::DistanceRange DensityBounds::part_in_box(const RaySegment& segment) {
    DistanceRange part{0, segment.length};
    for (int k = 0; k < 3; ++k) {
        const double o = segment.origin[k], d = segment.direction[k];
        if (d == 0) {
            if (!(o >= 0 && o <= 1)) part.end = 0;
            continue;
        }
        const double a = -o / d, b = (1 - o) / d;
        part.begin = std::max(part.begin, std::min(a, b));
        part.end = std::min(part.end, std::max(a, b));
    }
    return part;
}

std::optional<DensityBounds::Step> DensityBounds::Traversal::next() {
    const auto box = boxes_.next();
    if (!box) return std::nullopt;
    std::size_t number = 0;
    for (const std::size_t k : {2, 1, 0}) {
        const int size = bounds_.size_[k];  // roundings may take a ray out of the box at its end
        number = number * size + std::clamp(box->index[k], 0, size - 1);
    }
    const Range& range = bounds_.ranges_[number];
    return Step{range.least, range.most, box->end};
}

}  // namespace etalon
