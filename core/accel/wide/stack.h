#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/accel/tree/builder.h"
#include "core/accel/wide/wide_node.h"

namespace etalon {

/// A child that a ray enters, and the t of entry. t >= 0 is in the upper bits and the reference in
/// the lower ones, as non-negative floats are ordered like their bits.
class StackEntry {
  public:
    StackEntry() = default;
    StackEntry(float t, ChildRef child)
        : key_(std::uint64_t{std::bit_cast<std::uint32_t>(t)} << 32 | child.bits()) {}

    float t() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
    ChildRef child() const { return ChildRef(static_cast<std::uint32_t>(key_)); }
    bool operator<(const StackEntry& other) const { return key_ < other.key_; }

    /// Puts the nearer into `near`. Without a branch, as the order is not predictable.
    static void sort(StackEntry& near, StackEntry& far) {
        const std::uint64_t turn = -std::uint64_t{far < near} & (near.key_ ^ far.key_);
        near.key_ ^= turn;
        far.key_ ^= turn;
    }

  private:
    std::uint64_t key_;
};

/// Each level leaves at most seven siblings on the stack.
using StackSpace = std::array<StackEntry, (node_width - 1) * bvh_max_depth + node_width>;

/// Stack of the nodes that a ray has yet to visit, the next one last. The caller owns the space, so
/// that the members can be in registers.
class TraversalStack {
  public:
    explicit TraversalStack(StackSpace& space) : bottom_(space.data()), top_(bottom_) {}

    /// Takes the lanes `entered` of a node, at least one. Returns the nearest; the others are
    /// pushed so that nearer ones are popped earlier. The traversal waits for the result, so for
    /// one lane, or for two in the predicted order, the result does not depend on any t of entry.
    template <class LowestLane>
    ChildRef descend(const WideNode& node, const Lanes& entry, std::uint32_t entered) {
        const int lane = LowestLane::of(entered);
        const ChildRef child = node.children[lane];
        const std::uint32_t others = entered & (entered - 1);
        if (others == 0) return child;

        const int other_lane = std::countr_zero(others);
        const ChildRef other_child = node.children[other_lane];
        const StackEntry first(entry[lane], child), second(entry[other_lane], other_child);
        const std::uint32_t rest = others & (others - 1);
        if (rest != 0) return keep_sorted(first, second, node, entry, rest);

        const bool turned = second < first;
        *top_++ = turned ? first : second;
        return turned ? other_child : child;
    }

    /// The same in any order.
    template <class LowestLane>
    ChildRef descend(const WideNode& node, std::uint32_t entered) {
        ChildRef last = node.children[LowestLane::of(entered)];
        while ((entered &= entered - 1) != 0) {
            *top_++ = StackEntry(0, node.children[std::countr_zero(entered)]);
        }
        return last;
    }

    /// Pops the next node that is entered at or before tmax; false if there is none.
    bool pop(float tmax, ChildRef& next) {
        while (top_ != bottom_) {
            const StackEntry entry = *--top_;
            if (entry.t() > tmax) continue;
            next = entry.child();
            return true;
        }
        return false;
    }

  private:
    /// Pushes the farther of two entries and those of the lanes `rest`; returns the nearest.
    ChildRef keep_sorted(StackEntry near, StackEntry far, const WideNode& node, const Lanes& entry,
                         std::uint32_t rest) {
        StackEntry::sort(near, far);
        StackEntry* const first = top_;
        *top_++ = far;
        for (; rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            StackEntry next(entry[lane], node.children[lane]);
            StackEntry::sort(near, next);
            insert(first, next);
        }
        return near.child();
    }

    /// Inserts an entry among those from `first` on, above all that are farther.
    void insert(StackEntry* first, StackEntry entry) {
        StackEntry* place = top_++;
        for (; place != first && place[-1] < entry; --place) *place = place[-1];
        *place = entry;
    }

    StackEntry* const bottom_;
    StackEntry* top_;
};

}  // namespace etalon
