// Grids from items: coarse or fine, in each other or alone, as an estimate of what a ray costs
// says.
#pragma once

#include <numeric>
#include <optional>

#include "native_accel/grid/cost.h"
#include "native_accel/grid/distribution.h"

namespace etalon {

struct GridConfig {
    GridCost cost;
    double cells_per_item = 1;   ///< of a grid, at most
    double max_references = 12;  ///< times the number of items: no more are listed in all cells
    double max_work = 48;        ///< cells looked at for an item, on average, to cut a box once
    int max_depth = 6;           ///< grids in each other
    std::uint32_t serial_below = 4096;  ///< grids of fewer items are one thread's work
};

/// Top-down, on as many threads as allowed; the same for any number of them. No more than
/// max_references n references and, as the lists of one depth together hold no more,
/// about max_depth max_references cells_per_item n cells come of n items, whatever they are.
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
        tree.root = cell(tree, {box, std::move(all), budget, 0, 1});
        return tree;
    }

  private:
    /// What is to become a cell.
    struct Part {
        Box3 box;
        ItemNumbers items;
        double budget;  ///< as many references may come of it
        int depth;
        double reach;  ///< of the rays that cross the cell, as many cross the box
    };

    /// What of a cell there is anything in. It reaches as far beyond that as the list of a cell.
    Box3 content_of(const ItemNumbers& items, const Box3& cell) const {
        Box3f all;
        for (const std::uint32_t i : items) all.extendBy(items_[i].box);
        const Vec3 padding(grid_padding);
        Box3 content;
        for (int k = 0; k < 3; ++k) {
            content.min[k] = std::max<double>(all.min[k], cell.min[k]);
            content.max[k] = std::min<double>(all.max[k], cell.max[k]);
        }
        return {content.min - padding, content.max + padding};
    }

    GridCell cell(GridTree& tree, const Part& part) const {
        if (const auto layout = best_layout(part)) return grid(tree, part, *layout);
        const auto first = static_cast<std::uint32_t>(tree.items.size());
        tree.items.insert(tree.items.end(), part.items.begin(), part.items.end());
        return {first, static_cast<std::uint32_t>(part.items.size())};
    }

    GridCell grid(GridTree& tree, const Part& part, const GridLayout& layout) const {
        const CellLists lists = Distribution<Item>(items_, part.items, layout).lists();
        const auto node = static_cast<std::uint32_t>(tree.nodes.size());
        const auto first_cell = static_cast<std::uint32_t>(tree.cells.size());
        tree.nodes.push_back(layout.node(first_cell));
        tree.cells.resize(first_cell + layout.size());
        const auto child = [&](GridTree& into, std::uint32_t c) {
            const ItemNumbers items(lists.items.begin() + lists.begin[c],
                                    lists.items.begin() + lists.begin[c + 1]);
            const double share = static_cast<double>(items.size()) / lists.begin.back();
            const Box3 all = layout.box_of(c), content = content_of(items, all);
            const double reach = half_area(content.size()) / half_area(all.size());
            return cell(
                into, {content, items, share * part.budget, part.depth + 1, std::min(reach, 1.0)});
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

    /// The children in groups of about as many items, each built on its own and then appended.
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

    /// Where what is appended to a tree comes to lie.
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

    /// Whether it would not take too long to find out what it costs to cut so.
    bool is_allowed(const Part& part, const GridLayout& layout) const {
        const auto items = static_cast<double>(part.items.size());
        const double limit = std::min(part.budget, config_.max_work * items);
        return Distribution<Item>(items_, part.items, layout).box_references() <= limit;
    }

    /// What a ray through the box costs if it is cut so, and so many of all pass through a cell;
    /// infinity where nothing would be gained.
    double cost(const Part& part, const GridLayout& layout, double share_of_rays) const {
        double sum = static_cast<double>(layout.size()), references = 0;
        std::uint32_t fullest = 0;
        for (const std::uint32_t count :
             Distribution<Item>(items_, part.items, layout).box_counts()) {
            sum += config_.cost.cell(count);
            references += count;
            fullest = std::max(fullest, count);
        }
        const auto items = static_cast<double>(part.items.size());
        const bool no_progress = fullest == part.items.size() && references > 2 * items;
        if (no_progress || references > part.budget) return infinity;
        return part.reach * (config_.cost.enter + share_of_rays * sum);
    }

    /// A layout, if it costs less than `cost`.
    struct Choice {
        std::optional<GridLayout> layout;
        double cost;
    };

    std::optional<GridLayout> best_layout(const Part& part) const {
        const auto count = static_cast<std::uint32_t>(part.items.size());
        if (config_.cost.is_short(count) || part.depth == config_.max_depth) return std::nullopt;
        const Choice as_list{std::nullopt, config_.cost.list(count)};
        const Choice cubes = best_layout(part, Cut::cubes, as_list);
        const Vec3 size = part.box.size();
        const bool is_long = max_abs(size) > 4 * std::min({size.x, size.y, size.z});
        if (!is_long) return cubes.layout;
        const Choice alike = best_layout(part, Cut::alike, as_list);
        return is_safer(part, alike, cubes) ? alike.layout : cubes.layout;
    }

    /// Few of all rays go along a box that is long, so that cubes cost less; but where those few
    /// would cost many times more, as in a mesh that is a needle, they are what counts.
    bool is_safer(const Part& part, const Choice& choice, const Choice& other) const {
        constexpr double much = 8;
        if (!choice.layout || !other.layout) return choice.layout.has_value();
        return much * cost(part, *choice.layout, choice.layout->share_along_axes()) <
               cost(part, *other.layout, other.layout->share_along_axes());
    }

    /// From about as many cells as items to ever fewer, as long as that is better.
    Choice best_layout(const Part& part, Cut cut, Choice best) const {
        bool allowed = false, found = false;
        for (double cells = config_.cells_per_item * static_cast<double>(part.items.size());
             cells >= 4; cells /= 2) {
            const GridLayout layout(part.box, cells, cut);
            allowed = allowed || is_allowed(part, layout);  // coarser cuts then hardly need more
            if (!allowed) continue;
            const double c = cost(part, layout, layout.share_of_rays());
            if (c >= best.cost && found) break;
            if (c < best.cost) best = {layout, c}, found = true;
        }
        return best;
    }

    std::span<const Item> items_;
    GridConfig config_;
};

}  // namespace etalon
