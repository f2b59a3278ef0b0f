// Traversal from node to node of a wide tree. Compiled for each instruction set.
#if defined(ETALON_TRAVERSAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_TRAVERSAL_INL_H
#undef ETALON_TRAVERSAL_INL_H
#else
#define ETALON_TRAVERSAL_INL_H
#endif

#include "core/accel/wide/slabs-inl.h"
#include "core/accel/wide/stack.h"
#include "core/accel/wide/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Visits the nearest child that a ray enters first; the others are pushed.
template <class LowestLane>
struct FrontToBack {
    HWY_INLINE ChildRef operator()(TraversalStack& stack, const WideNode& node, const Lanes& entry,
                                   std::uint32_t entered) const {
        return stack.descend<LowestLane>(node, entry, entered);
    }
};

/// Visits the children that a ray enters in any order.
template <class LowestLane>
struct AnyOrder {
    HWY_INLINE ChildRef operator()(TraversalStack& stack, const WideNode& node, const Lanes&,
                                   std::uint32_t entered) const {
        return stack.descend<LowestLane>(node, entered);
    }
};

/// Traversal of the tree by one ray; `Boxes` is a SlabTest.
template <class Order, class Boxes, class Counters>
class Traversal {
  public:
    HWY_INLINE Traversal(const WideTree& tree, const Boxes& boxes, StackSpace& space, Order,
                         Counters counters)
        : tree_(tree), boxes_(boxes), stack_(space), counters_(counters), next_(tree.root) {}

    /// Returns whether the ray enters the tree before tmax. Many rays do not, and need no more set
    /// up.
    HWY_INLINE bool begin(float tmax) { return next_.is_leaf() || descend(tmax); }

    /// Passes the leaves one by one to at_leaf(cluster), as long as that returns true. Call begin()
    /// first.
    template <class AtLeaf>
    HWY_INLINE void finish(const float& tmax, const AtLeaf& at_leaf) {
        do {
            while (!next_.is_leaf() && descend(tmax)) {
            }
            if (next_.is_leaf() && !at_leaf(next_.cluster())) return;
        } while (stack_.pop(tmax, next_));
    }

    HWY_INLINE Counters counters() const { return counters_; }

  private:
    /// Moves from a node to a child. Returns false if the ray enters none.
    HWY_INLINE bool descend(float tmax) {
        const WideNode& node = tree_.nodes[next_.node()];
        counters_.boxes(node);
        alignas(32) Lanes entry;
        const std::uint32_t entered = boxes_.entered(node, tmax, entry);
        if (entered == 0) return false;
        next_ = Order()(stack_, node, entry, entered);
        return true;
    }

    const WideTree& tree_;
    const Boxes& boxes_;
    TraversalStack stack_;
    [[no_unique_address]] const Counters counters_;
    ChildRef next_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
