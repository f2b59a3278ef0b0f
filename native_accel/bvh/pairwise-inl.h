// Traversal of two nodes at a time, for rays that ask whether anything is hit at all. Compiled for
// each instruction set.
#if defined(ETALON_BVH_PAIRWISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_BVH_PAIRWISE_INL_H
#undef ETALON_BVH_PAIRWISE_INL_H
#else
#define ETALON_BVH_PAIRWISE_INL_H
#endif

#include <bit>

#include "core/accel/tree/builder.h"
#include "native_accel/bvh/wide_tree.h"
#include "native_accel/common/slabs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Stack of children that a ray enters. Of bits, as a ChildRef is set when it is made.
template <std::size_t most>
class ChildStack {
  public:
    bool empty() const { return size_ == 0; }
    ChildRef pop() { return ChildRef(bits_[--size_]); }
    void push(ChildRef child) { bits_[size_++] = child.bits(); }

    HWY_INLINE void push(const WideNode& node, std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) push(node.children[std::countr_zero(lanes)]);
    }

  private:
    std::array<std::uint32_t, most> bits_;
    std::size_t size_ = 0;
};

/// The lanes, lowest first, whose children are leaves: the sign of a ChildRef's bits tells.
HWY_INLINE std::uint32_t leaves_of(const WideNode& node) {
    const hn::Rebind<std::int32_t, Tag> numbers;
    const auto* const children = reinterpret_cast<const std::int32_t*>(node.children.data());
    return lanes_where([&](std::size_t i) HWY_ATTR {
        const auto is_leaf = hn::Lt(hn::Load(numbers, children + i), hn::Zero(numbers));
        return hn::RebindMask(Tag(), is_leaf);
    });
}

/// Leaves are asked as soon as they are met. Nodes are taken two at a time, so that the boxes of
/// one are tested while those of the other are waited for: for a ray that meets nothing any order
/// is as good, as it visits all that it enters.
template <class Boxes>
class PairwiseTraversal {
  public:
    HWY_INLINE PairwiseTraversal(const WideTree& tree, const Boxes& boxes, float tmax)
        : tree_(tree), boxes_(boxes), tmax_(tmax) {}

    /// Returns whether the ray meets the tree at all: many do not, and need no more set up.
    HWY_INLINE bool begin() {
        if (tree_.root.is_leaf()) {
            leaves_.push(tree_.root);
        } else {
            const WideNode& root = tree_.nodes[tree_.root.node()];
            push(root, entered(root));
        }
        return !(nodes_.empty() && leaves_.empty());
    }

    /// Whether, after begin(), at_leaf(cluster) returns true for any leaf.
    template <class AtLeaf>
    HWY_INLINE bool finish(const AtLeaf& at_leaf) {
        for (;;) {
            while (!leaves_.empty()) {
                if (at_leaf(leaves_.pop().cluster())) return true;
            }
            if (nodes_.empty()) return false;
            const WideNode& first = pop();
            if (nodes_.empty()) {
                push(first, entered(first));
            } else {
                const WideNode& second = pop();
                const std::uint32_t of_first = entered(first), of_second = entered(second);
                push(second, of_second);
                push(first, of_first);
            }
        }
    }

  private:
    HWY_INLINE const WideNode& pop() { return tree_.nodes[nodes_.pop().node()]; }

    HWY_INLINE std::uint32_t entered(const WideNode& node) const {
        alignas(32) Lanes entry;
        return boxes_.entered(node, tmax_, entry);
    }

    HWY_INLINE void push(const WideNode& node, std::uint32_t lanes) {
        const std::uint32_t leaves = leaves_of(node);
        nodes_.push(node, lanes & ~leaves);
        leaves_.push(node, lanes & leaves);
    }

    const WideTree& tree_;
    const Boxes& boxes_;
    const float tmax_;
    /// What is pushed later is deeper, so that of each depth there are the children of two nodes.
    ChildStack<2 * node_width*(bvh_max_depth + 1)> nodes_;
    ChildStack<2 * node_width> leaves_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
