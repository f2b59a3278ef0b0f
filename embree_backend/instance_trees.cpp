#include "embree_backend/instance_trees.h"

#include <algorithm>

namespace etalon {
namespace {

/// Largest size of an instance, and of a tree, in the normalized space of the scene, whose boxes
/// are padded by 2^-19 on each side.
constexpr float largest_instance = 0x1p-12F, largest_tree = 0x1p-3F;
constexpr std::ptrdiff_t fewest = 64;

float extent(const Box3f& box) {
    const Vec3f size = box.size();
    return std::max({size.x, size.y, size.z});
}

bool is_small(const Geometry& geometry, const BoundedPrimitive& p) {
    constexpr auto padding = static_cast<float>(2 * NormalizedSpace::padding);
    return p.kind == instance_kind && extent(p.box()) < largest_instance + padding &&
           geometry.instance_number(p.id) < ClusterRef::most_single;
}

/// The instances of a tree that is to be made.
struct Found {
    Box3f box;
    std::vector<std::uint32_t> items;
};

/// Collects the nodes of a binary tree that are small enough to be trees of their own, and have
/// enough instances.
class Finder {
  public:
    explicit Finder(const BvhTree& tree) : tree_(tree) { visit(0); }

    std::vector<Found> take() { return std::move(found_); }

  private:
    void visit(std::size_t index) {
        const BvhNode& node = tree_.nodes[index];
        const auto begin = tree_.ids.begin() + first(index), end = tree_.ids.begin() + last(index);
        if (end - begin < fewest) return;
        if (extent(node.box) < largest_tree) {
            found_.push_back({node.box, {begin, end}});
            std::ranges::sort(found_.back().items);
        } else if (!node.is_leaf()) {
            visit(node.first);
            visit(node.first + 1);
        }
    }

    /// The range of a node's primitives, which are in the order of the leaves.
    std::uint32_t first(std::size_t index) const {
        while (!tree_.nodes[index].is_leaf()) index = tree_.nodes[index].first;
        return tree_.nodes[index].first;
    }
    std::uint32_t last(std::size_t index) const {
        while (!tree_.nodes[index].is_leaf()) index = tree_.nodes[index].first + 1;
        return tree_.nodes[index].first + tree_.nodes[index].count;
    }

    const BvhTree& tree_;
    std::vector<Found> found_;
};

std::vector<Found> find(const Geometry& geometry, const std::vector<BoundedPrimitive>& singles) {
    std::vector<BoundedPrimitive> small;
    std::ranges::copy_if(singles, std::back_inserter(small),
                         [&](const BoundedPrimitive& p) { return is_small(geometry, p); });
    if (std::ssize(small) < fewest) return {};
    return Finder(build_bvh(std::move(small))).take();
}

InstanceBounds bounds_with_least_padding(const Geometry& geometry, const NormalizedSpace& scene) {
    const Vec3 &centre = scene.centre(), &reach = scene.reach();
    return instance_bounds(geometry, Box3(centre - reach, centre + reach), NearRegion(),
                           least_padding);
}

}  // namespace

InstanceTrees::InstanceTrees(const Geometry& geometry, const NormalizedSpace& scene,
                             std::vector<BoundedPrimitive>& singles)
    : InstanceTrees() {
    std::vector<Found> found = find(geometry, singles);
    if (found.empty()) return;
    std::vector<bool> is_taken(geometry.item_count());
    for (const Found& of_tree : found) {
        for (const std::uint32_t item : of_tree.items) is_taken[item] = true;
    }
    std::erase_if(singles, [&](const BoundedPrimitive& p) { return is_taken[p.id]; });
    const InstanceBounds bounds = bounds_with_least_padding(geometry, scene);
    std::vector<BoundedPrimitive> boxes;
    for (Found& of_tree : found) {
        const auto number = static_cast<std::uint32_t>(trees_.size());
        boxes.emplace_back(of_tree.box, number, instance_kind);
        singles.emplace_back(of_tree.box, geometry.item_count() + number, instance_kind);
        trees_.emplace_back(geometry, scene, bounds, std::move(of_tree.items));
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
