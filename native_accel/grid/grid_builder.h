// Building of grids: coarse or fine, nested or not, by the estimated cost of a ray.
#pragma once

#include <numeric>

#include "native_accel/grid/layout_choice.h"

namespace etalon {

/// Builds grids top-down, on as many threads as allowed; the result is the same for any number of
/// them. For n items of any kind there are at most max_references n references and, since the lists
/// of one depth together hold no more, about max_depth max_references cells_per_item n cells.
template <class Item>
class GridBuilder {
  public:
    GridBuilder(std::span<const Item> items, const GridConfig& config)
        : items_(items), config_(config) {}

    GridTree build(const Box3& box) const {
        GridTree tree;
        ItemNumbers all(items_.size());
        std::iota(all.begin(), all.end(), 0U);
        const double budget = config_.max_references * static_cast<double>(all.size());
        tree.root = cell(tree, {box, std::move(all), budget, 0});
        return tree;
    }

  private:
    GridCell cell(GridTree& tree, GridPart part) const {
        if (!LayoutChoice<Item>::may_gain(part, config_)) return list(tree, part.items);
        shrink_to_content(part);
        const auto layout = LayoutChoice<Item>(items_, config_, part).best();
        return layout ? grid(tree, part, *layout) : list(tree, part.items);
    }

    GridCell list(GridTree& tree, const ItemNumbers& items) const {
        const auto first = static_cast<std::uint32_t>(tree.items.size());
        tree.items.insert(tree.items.end(), items.begin(), items.end());
        return {first, static_cast<std::uint32_t>(items.size())};
    }

    /// Shrinks a cell to the part of it that has any content, plus the margin by which the list of
    /// a cell reaches beyond it.
    void shrink_to_content(GridPart& part) const {
        Box3f all;
        for (const std::uint32_t i : part.items) all.extendBy(items_[i].box);
        const double before = half_area(part.box.size());
        for (int k = 0; k < 3; ++k) {
            part.box.min[k] = std::max<double>(all.min[k], part.box.min[k]) - grid_padding;
            part.box.max[k] = std::min<double>(all.max[k], part.box.max[k]) + grid_padding;
        }
        part.reach = std::min(half_area(part.box.size()) / before, 1.0);
    }

    GridCell grid(GridTree& tree, const GridPart& part, const GridLayout& layout) const {
        const CellLists lists = Distribution<Item>(items_, part.items, layout).lists();
        const auto node = static_cast<std::uint32_t>(tree.nodes.size());
        const auto first_cell = static_cast<std::uint32_t>(tree.cells.size());
        tree.nodes.push_back(layout.node(first_cell));
        tree.cells.resize(first_cell + layout.size());
        const auto child = [&](GridTree& into, std::uint32_t c) {
            const ItemNumbers items(lists.items.begin() + lists.begin[c],
                                    lists.items.begin() + lists.begin[c + 1]);
            const double share = static_cast<double>(items.size()) / lists.begin.back();
            return cell(into, {layout.box_of(c), items, share * part.budget, part.depth + 1});
        };
        if (part.items.size() < config_.serial_below) {
            for (std::uint32_t c = 0; c < layout.size(); ++c) {
                if (lists.begin[c] < lists.begin[c + 1]) {
                    const GridCell built = child(tree, c);
                    tree.cells[first_cell + c] = built;
                }
            }
        } else {
            in_groups(tree, first_cell, lists, child);
        }
        return {node, GridCell::grid};
    }

    /// Builds the children in groups of about as many items. Each group is built on its own and
    /// then appended.
    template <class Child>
    void in_groups(GridTree& tree, std::uint32_t first_cell, const CellLists& lists,
                   const Child& child) const {
        std::vector<std::uint32_t> ends;
        const auto cells = static_cast<std::uint32_t>(lists.begin.size() - 1);
        for (std::uint32_t c = 0, items = 0; c < cells; ++c) {
            items += lists.begin[c + 1] - lists.begin[c];
            if (items < config_.serial_below / 2 && c + 1 < cells) continue;
            ends.push_back(c + 1);
            items = 0;
        }
        std::vector<GridTree> groups(ends.size());
        std::vector<GridCell> built(cells);
        parallel_for(groups.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t g = first; g < last; ++g) {
                for (std::uint32_t c = g == 0 ? 0 : ends[g - 1]; c < ends[g]; ++c) {
                    if (lists.begin[c] < lists.begin[c + 1]) built[c] = child(groups[g], c);
                }
            }
        });
        for (std::size_t g = 0; g < groups.size(); ++g) {
            const Moved moved(tree);
            for (std::uint32_t c = g == 0 ? 0 : ends[g - 1]; c < ends[g]; ++c) {
                tree.cells[first_cell + c] = moved(built[c]);
            }
            moved.append(groups[g], tree);
        }
    }

    /// Offsets of the entries that are appended to a tree.
    struct Moved {
        explicit Moved(const GridTree& tree)
            : nodes(static_cast<std::uint32_t>(tree.nodes.size())),
              cells(static_cast<std::uint32_t>(tree.cells.size())),
              items(static_cast<std::uint32_t>(tree.items.size())) {}

        GridCell operator()(GridCell c) const {
            if (c.count != 0) c.first += c.is_grid() ? nodes : items;
            return c;
        }

        void append(const GridTree& part, GridTree& tree) const {
            for (GridNode node : part.nodes) {
                node.first_cell += cells;
                tree.nodes.push_back(node);
            }
            for (const GridCell& c : part.cells) tree.cells.push_back((*this)(c));
            tree.items.insert(tree.items.end(), part.items.begin(), part.items.end());
        }

        std::uint32_t nodes, cells, items;
    };

    std::span<const Item> items_;
    GridConfig config_;
};

}  // namespace etalon
