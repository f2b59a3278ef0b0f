#include "core/intersect/far_tree.h"

#include <algorithm>

#include "core/intersect/kernels.h"

namespace etalon {
namespace {

/// Margin of a primitive's box, for kernels that round: a fraction of its largest coordinate.
constexpr double box_margin = 0x1p-30;

/// Margin of the t at which a ray enters or leaves a slab: for the t of a kernel, which is good to
/// t_tolerance, twice that, which leaves far more than the roundings of two operations here; and
/// for what is denormal.
double margin_of(double t) {
    return std::abs(t) * 2 * t_tolerance + 0x1p-1000;
}

Box3 padded(const Box3& box) {
    const Vec3 margin(box_margin * std::max(max_abs(box.min), max_abs(box.max)));
    return {box.min - margin, box.max + margin};
}

}  // namespace

struct FarTree::Item {
    Box3 box;
    Vec3 centre;
    std::uint32_t id;
};

FarTree::FarTree(const Geometry& geometry, const std::vector<std::uint32_t>& primitives) {
    std::vector<Item> items;
    items.reserve(primitives.size());
    for (const std::uint32_t id : primitives) {
        const Box3 box = padded(whole_bounds(geometry, id));
        items.push_back({box, 0.5 * box.min + 0.5 * box.max, id});
    }
    ids_.reserve(items.size());
    nodes_.reserve(items.size());
    nodes_.emplace_back();
    build(0, items);
}

/// Splits at the median along the longest axis: there are few such primitives.
void FarTree::build(std::size_t node, std::span<Item> items) {
    Box3 box, centres;
    for (const Item& item : items) {
        box.extendBy(item.box);
        centres.extendBy(item.centre);
    }
    if (items.size() <= most_in_leaf) {
        nodes_[node] = {box, static_cast<std::uint32_t>(ids_.size()),
                        static_cast<std::uint32_t>(items.size())};
        for (const Item& item : items) ids_.push_back(item.id);
        return;
    }
    const auto axis = static_cast<int>(centres.majorAxis());
    const std::size_t half = items.size() / 2;
    std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [axis](const Item& item) { return item.centre[axis]; });
    const std::size_t first = nodes_.size();
    nodes_.resize(first + 2);
    nodes_[node] = {box, static_cast<std::uint32_t>(first), 0};
    build(first, items.first(half));
    build(first + 1, items.subspan(half));
}

FarTree::Passage FarTree::passage(const Ray& ray, const Box3& box, double tmax) {
    Passage range{ray.tmin, tmax};
    for (int k = 0; k < 3; ++k) {
        const double o = ray.origin[k], d = ray.direction[k];
        if (d == 0) {
            if (o < box.min[k] || o > box.max[k]) return {infinity, -infinity};
            continue;
        }
        const double entry = ((d > 0 ? box.min : box.max)[k] - o) / d;
        const double exit = ((d > 0 ? box.max : box.min)[k] - o) / d;
        range.entry = std::max(range.entry, entry - margin_of(entry));
        range.exit = std::min(range.exit, exit + margin_of(exit));
    }
    return range;
}

}  // namespace etalon
