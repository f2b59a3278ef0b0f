#pragma once

#include "core/intersect/bounded.h"
#include "embree_backend/instance_tree.h"

namespace etalon {

/// The instance trees of one scene.
class InstanceTrees {
  public:
    InstanceTrees() { largest_.clear(); }

    /// Makes trees of the tiny instances among `singles`, the bounded primitives that have no
    /// filter. Puts the box of a tree in the place of its instances; its id is item_count() plus
    /// the tree's index.
    InstanceTrees(const Geometry& geometry, const NormalizedSpace& scene,
                  std::vector<BoundedPrimitive>& singles);

    bool empty() const { return trees_.empty(); }
    const InstanceTree& operator[](std::size_t index) const { return trees_[index]; }

    /// Returns the boxes, in the scene's space, of the up to eight trees that have the most
    /// instances, the smallest box first. The children are not nodes, but indices of trees.
    const WideNode& largest() const { return largest_; }

    std::size_t memory_bytes() const;

  private:
    void set_largest(std::vector<BoundedPrimitive> boxes);

    std::vector<InstanceTree> trees_;
    WideNode largest_;
};

}  // namespace etalon
