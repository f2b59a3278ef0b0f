// Eight boxes that are tested at once: a node of a wide tree, and the lists of the grid's cells.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/accel/clusters/clusters.h"

namespace etalon {

/// Child of a wide node: another node, by its index, or a cluster of primitives.
class ChildRef {
  public:
    static ChildRef node(std::size_t index) { return ChildRef(static_cast<std::uint32_t>(index)); }
    static ChildRef leaf(ClusterRef cluster) { return ChildRef(leaf_bit | cluster.bits); }
    explicit ChildRef(std::uint32_t from) : bits_(from) {}
    ChildRef() = default;

    bool is_leaf() const { return (bits_ & leaf_bit) != 0; }
    std::uint32_t node() const { return bits_; }
    ClusterRef cluster() const { return ClusterRef(bits_ & ~leaf_bit); }
    std::uint32_t bits() const { return bits_; }

  private:
    static constexpr std::uint32_t leaf_bit = 0x80000000U;

    std::uint32_t bits_ = 0;
};

inline constexpr std::size_t node_width = 8;

/// Eight children and their padded boxes in normalized space. Unused lanes hold a box that no ray
/// enters.
struct alignas(64) WideNode {
    /// Leaves the members uninitialized, so that large arrays are first touched by the threads that
    /// fill them.
    WideNode() {}

    /// Removes all children.
    void clear();
    void set(std::size_t lane, const Box3f& box, ChildRef child);

    /// Returns the number of children.
    std::size_t count() const;

    /// Returns the offset in `planes` of the lanes of an axis's min or max: min x, max x, min y,
    /// ...
    static constexpr std::size_t plane(int axis, bool max) {
        return (2 * axis + (max ? 1 : 0)) * node_width;
    }

    std::array<float, 6 * node_width> planes;
    std::array<ChildRef, node_width> children;
};

static_assert(sizeof(WideNode) == 256);

inline void WideNode::clear() {
    constexpr float far = std::numeric_limits<float>::infinity();
    for (std::size_t lane = 0; lane < node_width; ++lane) {
        set(lane, Box3f(Vec3f(far), Vec3f(-far)), ChildRef());
    }
}

inline void WideNode::set(std::size_t lane, const Box3f& box, ChildRef child) {
    for (int k = 0; k < 3; ++k) {
        planes[plane(k, false) + lane] = box.min[k];
        planes[plane(k, true) + lane] = box.max[k];
    }
    children[lane] = child;
}

inline std::size_t WideNode::count() const {
    const float* low = &planes[plane(0, false)];
    const float* high = &planes[plane(0, true)];
    std::size_t lane = 0;
    while (lane < node_width && low[lane] <= high[lane]) ++lane;
    return lane;
}

}  // namespace etalon
