// Grids from items, coarse or fine, in each other or alone, as an estimate of the cost of a ray
// says.
#pragma once

#include <optional>
#include <span>

#include "core/parallel/parallel.h"
#include "native_accel/grid/layout.h"
#include "native_accel/grid/overlap.h"
#include "native_accel/grid/walk.h"

namespace etalon {

/// Costs are in steps from one cell to the next.
struct GridConfig {
    double pack_cost = 1;   ///< of testing the items of a pack against a ray
    double enter_cost = 4;  ///< of beginning to walk through a grid
    std::uint32_t pack_size = 4;
    double max_references = 12;  ///< times the number of items: no more are listed in all cells
    double max_work = 48;        ///< cells looked at for an item, on average, to cut a box once
    int max_depth = 6;
};

template <class Item>
class GridBuilder {
  public:
    GridBuilder(std::span<const Item> items, const GridConfig& config)
        : items_(items), config_(config) {}

    GridTree build(const Box3& box) {
        GridTree tree;
        std::vector<std::uint32_t> all(items_.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        const double budget = config_.max_references * static_cast<double>(all.size());
        tree.root = cell(tree, {box, std::move(all), budget, 0});
        return tree;
    }

  private:
    using Numbers = std::vector<std::uint32_t>;

    /// A cell, and how many references may come of it.
    struct Part {
        Box3 box;
        Numbers items;
        double budget;
        int depth;
    };

    struct Choice {
        std::optional<GridLayout> layout;
        double cost;
    };

    GridCell cell(GridTree& tree, const Part& part) const {
        if (const auto layout = best_layout(part)) return grid(tree, part, *layout);
        const auto first = static_cast<std::uint32_t>(tree.items.size());
        tree.items.insert(tree.items.end(), part.items.begin(), part.items.end());
        return {first, static_cast<std::uint32_t>(part.items.size())};
    }

    GridCell grid(GridTree& tree, const Part& part, const GridLayout& layout) const {
        const Lists lists = distribute(part, layout);
        const auto node = static_cast<std::uint32_t>(tree.nodes.size());
        const auto first_cell = static_cast<std::uint32_t>(tree.cells.size());
        tree.nodes.push_back(layout.node(first_cell));
        tree.cells.resize(first_cell + layout.size());
        const double share = part.budget / static_cast<double>(lists.items.size());
        for (std::uint32_t c = 0; c < layout.size(); ++c) {
            const auto begin = lists.items.begin() + lists.begin[c],
                       end = lists.items.begin() + lists.begin[c + 1];
            if (begin == end) continue;
            const double budget = share * static_cast<double>(end - begin);
            tree.cells[first_cell + c] =
                cell(tree, {layout.box_of(c), Numbers(begin, end), budget, part.depth + 1});
        }
        return {node, GridCell::grid};
    }

    struct Lists {
        Numbers begin, items;
    };

    Lists distribute(const Part& part, const GridLayout& layout) const {
        Lists lists;
        lists.begin.assign(layout.size() + 1, 0);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> listed;
        for (const std::uint32_t i : part.items) {
            for_each_cell(layout, items_[i], [&](std::uint32_t c) {
                listed.emplace_back(c, i);
                ++lists.begin[c + 1];
            });
        }
        for (std::size_t c = 1; c < lists.begin.size(); ++c) lists.begin[c] += lists.begin[c - 1];
        lists.items.resize(listed.size());
        Numbers next = lists.begin;
        for (const auto& [c, i] : listed) lists.items[next[c]++] = i;
        return lists;
    }

    /// Calls f(cell) for the cells the item might be hit in.
    template <class F>
    static void for_each_cell(const GridLayout& layout, const Item& item, const F& f) {
        CellIndex low, high;
        for (int k = 0; k < 3; ++k) {
            low[k] = layout.cell(item.box.min[k] - grid_padding, k);
            high[k] = layout.cell(item.box.max[k] + grid_padding, k);
        }
        if (low == high) return f(layout.flat(low));
        const Overlap<Item> overlap(item, layout.cell_size / 2 + Vec3(grid_padding));
        CellIndex c;
        for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) {
            for (c[1] = low[1]; c[1] <= high[1]; ++c[1]) {
                for (c[0] = low[0]; c[0] <= high[0]; ++c[0]) {
                    if (overlap.touches(layout.centre(c))) f(layout.flat(c));
                }
            }
        }
    }

    double work(const Part& part, const GridLayout& layout) const {
        double cells = 0;
        for (const std::uint32_t i : part.items) {
            double own = 1;
            for (int k = 0; k < 3; ++k) {
                own *= 1 + layout.cell(items_[i].box.max[k] + grid_padding, k) -
                       layout.cell(items_[i].box.min[k] - grid_padding, k);
            }
            cells += own;
        }
        return cells;
    }

    double list_cost(std::uint32_t count) const {
        return config_.pack_cost * ((count + config_.pack_size - 1) / config_.pack_size);
    }

    /// Of a cell that may be cut again.
    double cell_cost(std::uint32_t count) const {
        if (count <= config_.pack_size) return count == 0 ? 0 : config_.pack_cost;
        const double cut = config_.enter_cost + 2 * std::cbrt(count);
        return std::min(list_cost(count), cut);
    }

    /// What a ray through the box costs if it is cut so; infinity where that would take too much.
    double cost(const Part& part, const GridLayout& layout, Numbers& counts) const {
        if (work(part, layout) > config_.max_work * static_cast<double>(part.items.size())) {
            return infinity;
        }
        counts.assign(layout.size(), 0);
        for (const std::uint32_t i : part.items) {
            for_each_cell(layout, items_[i], [&](std::uint32_t c) { ++counts[c]; });
        }
        double references = 0, sum = static_cast<double>(layout.size());
        for (const std::uint32_t count : counts) {
            references += count;
            sum += cell_cost(count);
        }
        if (references > part.budget) return infinity;
        return config_.enter_cost + layout.share_of_rays() * sum;
    }

    std::optional<GridLayout> best_layout(const Part& part) const {
        std::optional<GridLayout> best;
        const auto count = static_cast<double>(part.items.size());
        if (part.items.size() <= config_.pack_size || part.depth >= config_.max_depth) return best;
        double least = list_cost(static_cast<std::uint32_t>(part.items.size()));
        Numbers counts;
        for (double cells = 4 * count; cells >= 8; cells /= 2) {
            const GridLayout layout(part.box, cells);
            const double c = cost(part, layout, counts);
            if (c < least) best = layout, least = c;
        }
        return best;
    }

    std::span<const Item> items_;
    GridConfig config_;
};

}  // namespace etalon
