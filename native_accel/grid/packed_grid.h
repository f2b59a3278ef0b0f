#pragma once

#include "core/numerics/rounding.h"
#include "native_accel/grid/grid_builder.h"

namespace etalon {

/// A grid whose cells hold packs of items that are tested together. An item that lies in many cells
/// is stored in each, so that a cell is one read from memory.
template <class Pack>
class PackedGrid {
    using Item = typename Pack::Item;
    static constexpr std::uint32_t lanes = Pack::cost.pack_size;

  public:
    PackedGrid() = default;

    explicit PackedGrid(const std::vector<Item>& items) {
        if (items.empty()) return;
        Box3 all;
        for (const Item& item : items) all.extendBy(Box3(Vec3(item.box.min), Vec3(item.box.max)));
        all = {all.min - Vec3(grid_padding), all.max + Vec3(grid_padding)};
        box_ = round_outward(all);
        tree_ = GridBuilder<Item>(items, {Pack::cost}).build(all);
        pack(items);
    }

    bool empty() const { return tree_.root.count == 0; }
    const Box3f& box() const { return box_; }
    const GridCell& root() const { return tree_.root; }
    const GridNode& node(const GridCell& c) const { return tree_.nodes[c.first]; }
    const GridCell& cell(std::uint32_t i) const { return tree_.cells[i]; }

    /// Returns the packs of a cell that is not a grid.
    std::span<const Pack> packs(const GridCell& c) const { return {&packs_[c.first], c.count}; }

    std::size_t memory_bytes() const {
        return tree_.nodes.capacity() * sizeof(GridNode) +
               tree_.cells.capacity() * sizeof(GridCell) + packs_.capacity() * sizeof(Pack);
    }

  private:
    /// Converts lists of items into packs.
    void pack(const std::vector<Item>& items) {
        const ItemNumbers listed = std::move(tree_.items);
        std::vector<std::uint32_t> firsts;
        std::uint32_t count = packs_of(tree_.root);
        for (const GridCell& c : tree_.cells) {
            firsts.push_back(count);
            count += packs_of(c);
        }
        packs_.resize(count);
        const auto fill = [&](GridCell& c, std::uint32_t first) {
            if (c.is_grid() || c.count == 0) return;
            for (std::uint32_t i = 0; i < c.count; ++i) {
                packs_[first + i / lanes].set(i % lanes, items[listed[c.first + i]]);
            }
            c = {first, packs_of(c)};
        };
        fill(tree_.root, 0);
        parallel_for(tree_.cells.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) fill(tree_.cells[c], firsts[c]);
        });
        tree_.cells.shrink_to_fit();
        tree_.nodes.shrink_to_fit();
    }

    static std::uint32_t packs_of(const GridCell& c) {
        return c.is_grid() ? 0 : (c.count + lanes - 1) / lanes;
    }

    Box3f box_;
    GridTree tree_;
    std::vector<Pack> packs_;
};

}  // namespace etalon
