// Distribution of items to cells: a counting pass, prefix sums and a filling pass, on as many
// threads as allowed.
#pragma once

#include <atomic>
#include <span>
#include <utility>

#include "core/parallel/parallel.h"
#include "native_accel/grid/layout.h"
#include "native_accel/grid/overlap.h"

namespace etalon {

using ItemNumbers = std::vector<std::uint32_t>;

/// Lists of all cells: items[begin[c] ... begin[c + 1]) are in cell c, in ascending order.
struct CellLists {
    ItemNumbers begin, items;
};

template <class Item>
class Distribution {
  public:
    Distribution(std::span<const Item> items, const ItemNumbers& numbers, const GridLayout& layout)
        : items_(items), numbers_(numbers), layout_(layout) {}

    /// Returns the total number of cells that the items' boxes overlap.
    double box_references() const {
        double sum = 0;
        for (const std::uint32_t i : numbers_) sum += layout_.cells_of(items_[i].box).size();
        return sum;
    }

    /// Returns the number of items whose boxes overlap each cell.
    ItemNumbers box_counts() const {
        ItemNumbers counts(layout_.size(), 0);
        for_each_part([&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                for_each(layout_.cells_of(items_[numbers_[n]].box),
                         [&](const CellIndex& c) { increment(counts[layout_.flat(c)]); });
            }
        });
        return counts;
    }

    /// Returns the items that might be hit in each cell.
    CellLists lists() const {
        CellLists lists;
        lists.begin.assign(layout_.size() + 1, 0);
        std::vector<References> parts(part_count());
        for_each_part([&](std::size_t part, std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                for_each_cell(numbers_[n], [&](std::uint32_t c) {
                    parts[part].emplace_back(c, numbers_[n]);
                    increment(lists.begin[c + 1]);
                });
            }
        });
        for (std::size_t c = 1; c < lists.begin.size(); ++c) lists.begin[c] += lists.begin[c - 1];
        fill(parts, lists);
        return lists;
    }

  private:
    /// Pairs of a cell and an item in it.
    using References = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    static constexpr std::size_t part_size = 8192;  ///< number of items in one work item

    std::size_t part_count() const { return (numbers_.size() + part_size - 1) / part_size; }

    /// Calls f(part, begin, end) for ranges of numbers_.
    template <class F>
    void for_each_part(const F& f) const {
        if (part_count() == 1) return f(0, 0, numbers_.size());
        parallel_for(part_count(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t part = first; part < last; ++part) {
                f(part, part * part_size, std::min((part + 1) * part_size, numbers_.size()));
            }
        });
    }

    /// Increments a counter, atomically if needed, and returns its previous value.
    std::uint32_t increment(std::uint32_t& counter) const {
        if (part_count() == 1) return counter++;
        return std::atomic_ref(counter).fetch_add(1, std::memory_order_relaxed);
    }

    template <class F>
    static void for_each(const CellRange& range, const F& f) {
        if (range.is_one_cell()) return f(range.low);
        CellIndex c;
        for (c[2] = range.low[2]; c[2] <= range.high[2]; ++c[2]) {
            for (c[1] = range.low[1]; c[1] <= range.high[1]; ++c[1]) {
                for (c[0] = range.low[0]; c[0] <= range.high[0]; ++c[0]) f(c);
            }
        }
    }

    /// Calls f(cell) for the cells in which the item itself, not only its box, might be hit.
    template <class F>
    void for_each_cell(std::uint32_t item, const F& f) const {
        const CellRange range = layout_.cells_of(items_[item].box);
        if (range.is_one_cell()) return f(layout_.flat(range.low));
        const Vec3 half_size = layout_.cell_size() / 2 + Vec3(grid_padding);
        const Overlap<Item> overlap(items_[item], half_size);
        for_each(range, [&](const CellIndex& c) {
            if (overlap.touches(layout_.centre(c))) f(layout_.flat(c));
        });
    }

    void fill(const std::vector<References>& parts, CellLists& lists) const {
        lists.items.resize(lists.begin.back());
        ItemNumbers next = lists.begin;
        for_each_part([&](std::size_t part, std::size_t, std::size_t) {
            for (const auto& [c, item] : parts[part]) lists.items[increment(next[c])] = item;
        });
        if (part_count() == 1) return;
        // Threads append in any order.
        parallel_for(layout_.size(), 4096, [&](std::size_t first, std::size_t last) {
            for (std::size_t c = first; c < last; ++c) {
                std::sort(lists.items.begin() + lists.begin[c],
                          lists.items.begin() + lists.begin[c + 1]);
            }
        });
    }

    std::span<const Item> items_;
    const ItemNumbers& numbers_;
    const GridLayout& layout_;
};

}  // namespace etalon
