// Traversal of two nodes at a time, for occlusion queries. Compiled for each instruction set.
#if defined(ETALON_PAIRWISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_PAIRWISE_INL_H
#undef ETALON_PAIRWISE_INL_H
#else
#define ETALON_PAIRWISE_INL_H
#endif

#include <bit>

#include "core/accel/tree/builder.h"
#include "core/accel/wide/slabs-inl.h"
#include "core/accel/wide/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Stack of the children that a ray enters. It holds bits, since a ChildRef is initialized when it
/// is constructed.
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

/// Returns the lanes, lowest first, whose children are leaves: the sign of a ChildRef's bits tells.
HWY_INLINE std::uint32_t leaves_of(const WideNode& node) {
    const hn::Rebind<std::int32_t, Tag> numbers;
    const auto* const children = reinterpret_cast<const std::int32_t*>(node.children.data());
    return lanes_where([&](std::size_t i) HWY_ATTR {
        const auto is_leaf = hn::Lt(hn::Load(numbers, children + i), hn::Zero(numbers));
        return hn::RebindMask(Tag(), is_leaf);
    });
}

/// Tests leaves as soon as they are reached. Takes nodes two at a time, so that the boxes of one
/// are tested while those of the other are loaded. For a ray that hits nothing any order is as
/// good, as it visits every node that it enters.
template <class Boxes>
class PairwiseTraversal {
  public:
    HWY_INLINE PairwiseTraversal(const WideTree& tree, const Boxes& boxes, float tmax)
        : tree_(tree), boxes_(boxes), tmax_(tmax) {}

    /// Returns whether the ray enters the tree. Many rays do not, and need no more set up.
    HWY_INLINE bool begin() {
        if (tree_.root.is_leaf()) {
            leaves_.push(tree_.root);
        } else {
            const WideNode& root = tree_.nodes[tree_.root.node()];
            push(root, entered(root));
        }
        return !(nodes_.empty() && leaves_.empty());
    }

    /// Returns whether at_leaf(cluster) returned true for any leaf. Call begin() first.
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
    /// Nodes pushed later are deeper, so there are at most the children of two nodes of each depth.
    ChildStack<2 * node_width*(bvh_max_depth + 1)> nodes_;
    ChildStack<2 * node_width> leaves_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
