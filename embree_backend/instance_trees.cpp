#include "embree_backend/instance_trees.h"

#include <algorithm>

#include "embree_backend/tiny_instances.h"

namespace etalon {
namespace {

InstanceBounds bounds_with_least_padding(const Geometry& geometry, const NormalizedSpace& scene) {
    const Vec3 &centre = scene.centre(), &reach = scene.reach();
    return instance_bounds(geometry, Box3(centre - reach, centre + reach),
                           NearRegion{centre, max_abs(reach)}, least_padding);
}

}  // namespace

InstanceTrees::InstanceTrees(const Geometry& geometry, const NormalizedSpace& scene,
                             std::vector<BoundedPrimitive>& singles)
    : InstanceTrees() {
    std::vector<TinyInstances> found = find_tiny_instances(geometry, singles);
    if (found.empty()) return;
    std::vector<bool> is_taken(geometry.item_count());
    for (const TinyInstances& group : found) {
        for (const std::uint32_t item : group.items) is_taken[item] = true;
    }
    std::erase_if(singles, [&](const BoundedPrimitive& p) { return is_taken[p.id]; });
    const InstanceBounds bounds = bounds_with_least_padding(geometry, scene);
    std::vector<BoundedPrimitive> boxes;
    for (TinyInstances& group : found) {
        const auto index = static_cast<std::uint32_t>(trees_.size());
        boxes.emplace_back(group.box, index, instance_kind);
        singles.emplace_back(group.box, geometry.item_count() + index, instance_kind);
        trees_.emplace_back(geometry, scene, bounds, std::move(group.items));
    }
    set_largest(std::move(boxes));
}

void InstanceTrees::set_largest(std::vector<BoundedPrimitive> boxes) {
    const auto has_more = [&](const BoundedPrimitive& a, const BoundedPrimitive& b) {
        return trees_[a.id].items.size() > trees_[b.id].items.size();
    };
    std::ranges::stable_sort(boxes, has_more);
    boxes.resize(std::min(boxes.size(), node_width));
    std::ranges::stable_sort(boxes, std::ranges::less(),
                             [](const BoundedPrimitive& p) { return half_area(p.box()); });
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
        largest_.set(lane, boxes[lane].box(), ChildRef::node(boxes[lane].id));
    }
}

std::size_t InstanceTrees::memory_bytes() const {
    std::size_t bytes = 0;
    for (const InstanceTree& tree : trees_) bytes += sizeof(tree) + tree.memory_bytes();
    return bytes;
}

}  // namespace etalon
