#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/accel/tree/builder.h"
#include "native_accel/common/wide_node.h"

namespace etalon {

/// A child that a ray enters, and where: t >= 0 above the reference, as floats that are not
/// negative are ordered as their bits are.
class StackEntry {
  public:
    StackEntry() = default;
    StackEntry(float t, ChildRef child)
        : key_(std::uint64_t{std::bit_cast<std::uint32_t>(t)} << 32 | child.bits()) {}

    float t() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
    ChildRef child() const { return ChildRef(static_cast<std::uint32_t>(key_)); }
    bool operator<(const StackEntry& other) const { return key_ < other.key_; }

    /// Puts the nearer into `near`. Which it is nobody can predict: so without a branch.
    static void sort(StackEntry& near, StackEntry& far) {
        const std::uint64_t turn = -std::uint64_t{far < near} & (near.key_ ^ far.key_);
        near.key_ ^= turn;
        far.key_ ^= turn;
    }

  private:
    std::uint64_t key_;
};

/// Each level leaves at most seven siblings behind.
using StackSpace = std::array<StackEntry, (node_width - 1) * bvh_max_depth + node_width>;

/// Stack of what a ray has yet to visit, the next one last. The caller owns the space, apart, so
/// that all else can be in registers.
class TraversalStack {
  public:
    explicit TraversalStack(StackSpace& space) : bottom_(space.data()), top_(bottom_) {}

    /// Takes the lanes `entered` of a node, at least one, and gives back the nearest; the others
    /// are kept, the nearer the later. The traversal waits for what comes back: so of one lane, or
    /// of two in the order predicted, it depends on no place of entry.
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

    /// The same without regard to where the ray enters.
    template <class LowestLane>
    ChildRef descend(const WideNode& node, std::uint32_t entered) {
        ChildRef last = node.children[LowestLane::of(entered)];
        while ((entered &= entered - 1) != 0) {
            *top_++ = StackEntry(0, node.children[std::countr_zero(entered)]);
        }
        return last;
    }

    /// The next that is entered no later than at tmax; false where nothing is left.
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
    /// Pushes all but the nearest of two entries and those of the lanes `rest`; returns that one.
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

    /// Inserts an entry above those from `first` on that are further.
    void insert(StackEntry* first, StackEntry entry) {
        StackEntry* place = top_++;
        for (; place != first && place[-1] < entry; --place) *place = place[-1];
        *place = entry;
    }

    StackEntry* const bottom_;
    StackEntry* top_;
};

}  // namespace etalon
