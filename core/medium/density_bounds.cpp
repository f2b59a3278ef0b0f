#include "core/medium/density_bounds.h"

namespace etalon {
namespace {

/// Cells along each side of a box, by measurement, and the most boxes along an axis.
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

/// Bounds of the density in a box: of all cells whose middles its points are interpolated between.
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

DensityBounds::Walk::Walk(const DensityBounds& bounds, const RaySegment& segment)
    : bounds_(bounds), end_(segment.length) {
    for (int k = 0; k < 3; ++k) {
        const double o = segment.origin[k], d = segment.direction[k];
        if (d == 0) {
            if (!(o >= 0 && o <= 1)) end_ = 0;
            continue;
        }
        const double a = -o / d, b = (1 - o) / d;
        begin_ = std::max(begin_, std::min(a, b));
        end_ = std::min(end_, std::max(a, b));
    }
    here_ = begin_;
    if (begin_ < end_) enter(segment);
}

/// Finds the first box and its borders.
void DensityBounds::Walk::enter(const RaySegment& segment) {
    const Vec3 entry = segment.point(begin_);
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        const int boxes = bounds_.size_[k];
        const double d = segment.direction[axis];
        box_[k] = std::clamp(static_cast<int>(std::floor(entry[axis] * boxes)), 0, boxes - 1);
        step_[k] = d > 0 ? 1 : -1;
        width_[k] = d == 0 ? infinity : 1 / (boxes * std::abs(d));
        const double border = static_cast<double>(box_[k] + (d > 0 ? 1 : 0)) / boxes;
        border_[k] = d == 0 ? infinity : (border - segment.origin[axis]) / d;
    }
}

std::optional<DensityBounds::Step> DensityBounds::Walk::next() {
    if (!(here_ < end_)) return std::nullopt;
    const std::size_t axis = border_[0] < border_[1] ? (border_[0] < border_[2] ? 0 : 2)
                                                     : (border_[1] < border_[2] ? 1 : 2);
    const std::size_t number =
        (static_cast<std::size_t>(box_[2]) * bounds_.size_[1] + box_[1]) * bounds_.size_[0] +
        box_[0];
    const Range& range = bounds_.ranges_[number];
    here_ = std::max(here_, std::min(border_[axis], end_));
    const Step step{range.least, range.most, here_};
    box_[axis] += step_[axis];
    border_[axis] += width_[axis];
    if (box_[axis] < 0 || box_[axis] >= bounds_.size_[axis]) here_ = end_;
    return step;
}

}  // namespace etalon
