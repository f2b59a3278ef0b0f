// Choice of the cells into which a box is divided, if any, by the estimated cost of a ray.
#pragma once

#include <optional>

#include "native_accel/grid/cost.h"
#include "native_accel/grid/distribution.h"

namespace etalon {

struct GridConfig {
    GridCost cost;
    double cells_per_item = 1;   ///< most cells of a grid, for each item
    double max_references = 12;  ///< most references in all cells, for each item
    double max_work = 48;        ///< most cells visited for each item to evaluate one division
    int max_depth = 6;           ///< most levels of nested grids
    std::uint32_t serial_below = 4096;  ///< grids of fewer items are built by one thread
};

/// Part of the scene that is to become a cell.
struct GridPart {
    Box3 box;
    ItemNumbers items;
    double budget;     ///< most references that may result
    int depth;         ///< number of grids around it
    double reach = 1;  ///< rays that cross the box, for each ray that crosses the cell
};

template <class Item>
class LayoutChoice {
  public:
    LayoutChoice(std::span<const Item> items, const GridConfig& config, const GridPart& part)
        : items_(items), config_(config), part_(part) {}

    /// Returns false where no grid could be better than a list, or none is allowed.
    static bool may_gain(const GridPart& part, const GridConfig& config) {
        const auto count = static_cast<std::uint32_t>(part.items.size());
        return !config.cost.is_short(count) && part.depth < config.max_depth;
    }

    /// Returns the best layout, or none where a list is better than any.
    std::optional<GridLayout> best() const {
        const auto count = static_cast<std::uint32_t>(part_.items.size());
        const Choice as_list{std::nullopt, config_.cost.list(count)};
        const Choice cubes = best_layout(Cut::cubes, as_list);
        const Vec3 size = part_.box.size();
        const bool is_long = max_abs(size) > 4 * std::min({size.x, size.y, size.z});
        if (!is_long) return cubes.layout;
        const Choice equal = best_layout(Cut::equal_counts, as_list);
        return is_safer(equal, cubes) ? equal.layout : cubes.layout;
    }

  private:
    /// Returns whether the cost of a layout can be determined in reasonable time.
    bool is_allowed(const GridLayout& layout) const {
        const auto items = static_cast<double>(part_.items.size());
        const double limit = std::min(part_.budget, config_.max_work * items);
        return Distribution<Item>(items_, part_.items, layout).box_references() <= limit;
    }

    /// Returns the cost of a ray through the box with this layout, if the given share of all rays
    /// crosses a cell; infinity if nothing would be gained.
    double cost(const GridLayout& layout, double share_of_rays) const {
        double sum = static_cast<double>(layout.size()), references = 0;
        std::uint32_t fullest = 0;
        for (const std::uint32_t count :
             Distribution<Item>(items_, part_.items, layout).box_counts()) {
            sum += config_.cost.cell(count);
            references += count;
            fullest = std::max(fullest, count);
        }
        const auto items = static_cast<double>(part_.items.size());
        const bool no_progress = fullest == part_.items.size() && references > 2 * items;
        if (no_progress || references > part_.budget) return infinity;
        return part_.reach * (config_.cost.enter + share_of_rays * sum);
    }

    /// A layout, if it costs less than `cost`.
    struct Choice {
        std::optional<GridLayout> layout;
        double cost;
    };

    /// Few of all rays go along a long box, so that cubes cost less on average. But where those few
    /// would cost many times more, as in a needle-shaped mesh, they decide.
    bool is_safer(const Choice& choice, const Choice& other) const {
        constexpr double much = 8;
        if (!choice.layout || !other.layout) return choice.layout.has_value();
        return much * cost(*choice.layout, choice.layout->share_along_axes()) <
               cost(*other.layout, other.layout->share_along_axes());
    }

    /// Tries from about as many cells as items to ever fewer, as long as that is better.
    Choice best_layout(Cut cut, Choice best) const {
        bool allowed = false, found = false;
        for (double cells = config_.cells_per_item * static_cast<double>(part_.items.size());
             cells >= 4; cells /= 2) {
            const GridLayout layout(part_.box, cells, cut);
            allowed = allowed || is_allowed(layout);  // coarser cuts then hardly need more
            if (!allowed) continue;
            const double c = cost(layout, layout.share_of_rays());
            if (c >= best.cost && found) break;
            if (c < best.cost) best = {layout, c}, found = true;
        }
        return best;
    }

    std::span<const Item> items_;
    const GridConfig& config_;
    const GridPart& part_;
};

}  // namespace etalon
