#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/intersect/ray.h"
#include "core/scene/geometry.h"

namespace etalon {

/// A binary tree of primitives that reach far beyond all others of a scene, so that normalized
/// space has no room for them: see outliers.h. Its boxes are in world space and in double.
class FarTree {
  public:
    FarTree(const Geometry& geometry, const std::vector<std::uint32_t>& primitives);

    /// Calls visit(primitive) for the primitives that the ray may hit at `tmax` or before, as long
    /// as it returns true. `tmax` may decrease during calls. Returns whether visit always did.
    template <class Visit>
    bool visit(const Ray& ray, const double& tmax, const Visit& visit) const;

    std::size_t memory_bytes() const {
        return nodes_.capacity() * sizeof(Node) + ids_.capacity() * sizeof(std::uint32_t);
    }

  private:
    struct Item;

    /// A leaf has `count` primitives from `first` on; another node has the children `first` and
    /// `first` + 1.
    struct Node {
        Box3 box;
        std::uint32_t first, count;
    };

    /// Range of t in which a ray passes a box, widened by more than all roundings.
    struct Passage {
        bool is_empty() const { return !(entry <= exit); }

        double entry, exit;
    };

    void build(std::size_t node, std::span<Item> items);
    static Passage passage(const Ray& ray, const Box3& box, double tmax);

    static constexpr std::size_t most_in_leaf = 4;
    static constexpr std::size_t deepest = 40;  ///< each level halves the number of primitives

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> ids_;  ///< in the order of the leaves
};

template <class Visit>
bool FarTree::visit(const Ray& ray, const double& tmax, const Visit& visit) const {
    std::array<std::uint32_t, deepest> stack;
    std::size_t size = 0;
    if (!passage(ray, nodes_[0].box, tmax).is_empty()) stack[size++] = 0;
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if (!visit(ids_[node.first + i])) return false;
        }
        if (node.count > 0) continue;
        const Passage a = passage(ray, nodes_[node.first].box, tmax);
        const Passage b = passage(ray, nodes_[node.first + 1].box, tmax);
        const std::uint32_t nearer = a.entry <= b.entry ? 0 : 1;
        if (!(nearer == 0 ? b : a).is_empty()) stack[size++] = node.first + 1 - nearer;
        if (!(nearer == 0 ? a : b).is_empty()) stack[size++] = node.first + nearer;
    }
    return true;
}

}  // namespace etalon
