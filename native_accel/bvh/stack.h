#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "native_accel/bvh/builder.h"
#include "native_accel/bvh/wide_node.h"

namespace etalon {

/// What a ray has yet to visit, the next one last.
class TraversalStack {
  public:
    /// Takes the lanes `entered` of a node, at least one, and gives back the nearest; the others
    /// are kept, the nearer the later.
    ChildRef descend(const WideNode& node, const Lanes& entry, std::uint32_t entered) {
        const auto take = [&] {
            const int lane = std::countr_zero(entered);
            entered &= entered - 1;
            return Entry(entry[lane], node.children[lane]);
        };
        const Entry first = take();
        if (entered == 0) return first.child();
        const Entry second = take(), near = std::min(first, second), far = std::max(first, second);
        if (entered == 0) {
            entries_[height_++] = far;
            return near.child();
        }
        const std::size_t bottom = height_;
        entries_[height_++] = far;
        entries_[height_++] = near;
        do {
            insert(bottom, take());
        } while (entered != 0);
        return entries_[--height_].child();
    }

    /// The same without regard to where the ray enters.
    ChildRef descend(const WideNode& node, std::uint32_t entered) {
        ChildRef last = node.children[std::countr_zero(entered)];
        while ((entered &= entered - 1) != 0) {
            entries_[height_++] = Entry(0, node.children[std::countr_zero(entered)]);
        }
        return last;
    }

    /// The next that is entered no later than at tmax; false where nothing is left.
    bool pop(float tmax, ChildRef& next) {
        while (height_ > 0) {
            const Entry entry = entries_[--height_];
            if (entry.t() > tmax) continue;
            next = entry.child();
            return true;
        }
        return false;
    }

  private:
    /// t >= 0 above the reference: floats that are not negative are ordered as their bits are.
    class Entry {
      public:
        Entry() = default;
        Entry(float t, ChildRef child)
            : key_(std::uint64_t{std::bit_cast<std::uint32_t>(t)} << 32 | child.bits()) {}

        float t() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
        ChildRef child() const { return ChildRef(static_cast<std::uint32_t>(key_)); }
        bool operator<(const Entry& other) const { return key_ < other.key_; }

      private:
        std::uint64_t key_;
    };

    /// Above the entries from `bottom` on that are further.
    void insert(std::size_t bottom, Entry entry) {
        std::size_t place = height_++;
        for (; place > bottom && entries_[place - 1] < entry; --place) {
            entries_[place] = entries_[place - 1];
        }
        entries_[place] = entry;
    }

    // Each level leaves at most seven siblings behind.
    std::array<Entry, (node_width - 1) * bvh_max_depth + node_width> entries_;
    std::size_t height_ = 0;
};

}  // namespace etalon
