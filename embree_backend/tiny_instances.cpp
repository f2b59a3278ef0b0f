#include "embree_backend/tiny_instances.h"

#include <algorithm>
#include <iterator>

#include "core/accel/clusters/clusters.h"
#include "core/accel/tree/builder.h"

namespace etalon {
namespace {

/// Largest size of an instance, and of a group, in the normalized space of the scene, whose boxes
/// are padded by 2^-19 on each side. Measured for plazas of nested sizes; a forest of a million
/// instances has none that are as small.
constexpr float largest_instance = 0x1p-12F, largest_group = 0x1p-3F;
constexpr std::ptrdiff_t fewest = 64;

float extent(const Box3f& box) {
    const Vec3f size = box.size();
    return std::max({size.x, size.y, size.z});
}

bool is_tiny(const Geometry& geometry, const BoundedPrimitive& p) {
    constexpr auto padding = static_cast<float>(2 * NormalizedSpace::padding);
    return p.kind == instance_kind && extent(p.box()) < largest_instance + padding &&
           geometry.instance_number(p.id) < ClusterRef::most_single;
}

/// Collects the nodes of a binary tree that are small enough for a group and have enough instances.
class Finder {
  public:
    explicit Finder(const BvhTree& tree) : tree_(tree) { visit(0); }

    std::vector<TinyInstances> take() { return std::move(found_); }

  private:
    void visit(std::size_t index) {
        const BvhNode& node = tree_.nodes[index];
        const auto begin = tree_.ids.begin() + first(index), end = tree_.ids.begin() + last(index);
        if (end - begin < fewest) return;
        if (extent(node.box) < largest_group) {
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
    std::vector<TinyInstances> found_;
};

}  // namespace

std::vector<TinyInstances> find_tiny_instances(const Geometry& geometry,
                                               const std::vector<BoundedPrimitive>& singles) {
    std::vector<BoundedPrimitive> tiny;
    std::ranges::copy_if(singles, std::back_inserter(tiny),
                         [&](const BoundedPrimitive& p) { return is_tiny(geometry, p); });
    if (std::ssize(tiny) < fewest) return {};
    return Finder(build_bvh(std::move(tiny))).take();
}

}  // namespace etalon
