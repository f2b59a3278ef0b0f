// Building of a light tree.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/light/light_tree.h"
#include "core/parallel/parallel.h"
#include "core/scene/geometry.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Relative room for the roundings of a float and of computations with it.
constexpr double slack = 1e-6;

}  // namespace

/// Splits lights top-down where the cost of the halves is least. Subtrees are built in parallel: as
/// the number of their nodes is known, each has its place.
class LightTree::Builder {
  public:
    Builder(const std::vector<LightBounds>& bounds, LightTree& tree)
        : bounds_(bounds), tree_(tree), order_(bounds.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        std::erase_if(order_, [&](std::uint32_t i) { return !(bounds[i].intensity > 0); });
    }

    void build() {
        if (order_.empty()) return;
        tree_.nodes_.resize(2 * order_.size() - 1);
        tree_.parents_.resize(tree_.nodes_.size(), no_index);
        build({0, 1}, 0, order_.size(), 0);
    }

  private:
    static constexpr int bins = 12;
    static constexpr int deepest = 40;         ///< depth from which halves have equal numbers
    static constexpr std::size_t many = 1024;  ///< lights that are worth a task

    /// Places of a subtree's root and of the other nodes, which follow each other.
    struct Place {
        std::uint32_t root, others;
    };
    struct Bin {
        BoundsSum lights;
        std::size_t count = 0;
    };
    struct Split {
        double cost = infinity;
        int axis = 0, bin = 0;
    };

    Vec3 centre(std::uint32_t light) const { return bounds_[light].box.center(); }

    static int bin_of(const Vec3& centre, const Box3& centres, int axis) {
        const double size = centres.max[axis] - centres.min[axis];
        const int bin = static_cast<int>(bins * (centre[axis] - centres.min[axis]) / size);
        return std::clamp(bin, 0, bins - 1);
    }

    Split best_split(std::size_t first, std::size_t last, const Box3& centres, int axis) const {
        std::array<Bin, bins> filled;
        for (std::size_t i = first; i < last; ++i) {
            Bin& bin = filled[bin_of(centre(order_[i]), centres, axis)];
            bin.lights.add(bounds_[order_[i]]);
            ++bin.count;
        }
        std::array<double, bins + 1> above{};
        LightBounds side;
        for (int k = bins - 1; k > 0; --k) {
            above[k] = above[k + 1];
            if (filled[k].count == 0) continue;
            side = united(side, filled[k].lights.bounds());
            above[k] = cluster_cost(side);
        }
        Split best;
        side = {};
        std::size_t below = 0;
        for (int k = 0; k + 1 < bins; ++k) {
            if (filled[k].count == 0) continue;
            side = united(side, filled[k].lights.bounds());
            below += filled[k].count;
            if (below == last - first) break;
            const double cost = cluster_cost(side) + above[k + 1];
            if (cost < best.cost) best = {cost, axis, k + 1};
        }
        // Long boxes are cut across (section 4.4).
        const Vec3 size = centres.size();
        best.cost *= std::max({size.x, size.y, size.z}) / size[axis];
        return best;
    }

    /// Puts the lights of one half first; returns where those of the other begin.
    std::size_t split(std::size_t first, std::size_t last, int depth) {
        Box3 centres;
        for (std::size_t i = first; i < last; ++i) centres.extendBy(centre(order_[i]));
        const Vec3 size = centres.size();
        Split best;
        for (int axis = 0; axis < 3 && depth < deepest; ++axis) {
            if (!(size[axis] > 0)) continue;
            const Split found = best_split(first, last, centres, axis);
            if (found.cost < best.cost) best = found;
        }
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first),
                   end = order_.begin() + static_cast<std::ptrdiff_t>(last);
        const std::size_t middle = (first + last) / 2;
        if (best.bin == 0) {  // all in one place
            const int axis = static_cast<int>(centres.majorAxis());
            std::nth_element(begin, order_.begin() + static_cast<std::ptrdiff_t>(middle), end,
                             [&](std::uint32_t a, std::uint32_t b) {
                                 const double x = centre(a)[axis], y = centre(b)[axis];
                                 return x != y ? x < y : a < b;
                             });
            return middle;
        }
        const auto found = std::stable_partition(begin, end, [&](std::uint32_t light) {
            return bin_of(centre(light), centres, best.axis) < best.bin;
        });
        return static_cast<std::size_t>(found - order_.begin());
    }

    LightBounds build(const Place& at, std::size_t first, std::size_t last, int depth) {
        if (last - first == 1) return build_leaf(at.root, order_[first]);
        const std::size_t middle = split(first, last, depth);
        const std::uint32_t children = at.others;
        tree_.parents_[children] = tree_.parents_[children + 1] = at.root;
        const auto below_first = static_cast<std::uint32_t>(2 * (middle - first - 1));
        LightBounds a, b;
        const auto build_first = [&] {
            a = build({children, children + 2}, first, middle, depth + 1);
        };
        const auto build_second = [&] {
            b = build({children + 1, children + 2 + below_first}, middle, last, depth + 1);
        };
        if (last - first > many) {
            parallel_invoke(build_first, build_second);
        } else {
            build_first();
            build_second();
        }
        const LightBounds both = united(a, b);
        tree_.nodes_[at.root] = node_of(both);
        tree_.nodes_[at.root].first = children;
        return both;
    }

    const LightBounds& build_leaf(std::uint32_t node, std::uint32_t light) {
        tree_.nodes_[node] = node_of(bounds_[light]);
        tree_.nodes_[node].first = light;
        tree_.nodes_[node].is_leaf = true;
        tree_.leaves_[light] = node;
        return bounds_[light];
    }

    const std::vector<LightBounds>& bounds_;
    LightTree& tree_;
    std::vector<std::uint32_t> order_;
};

LightTree::LightTree(const std::vector<LightBounds>& bounds) : leaves_(bounds.size(), no_index) {
    Builder(bounds, *this).build();
}

LightTree::Node LightTree::node_of(const LightBounds& bounds) {
    Node node{};
    node.centre = bounds.box.center();
    const double error = slack * slack * slack * node.centre.length();
    node.radius = static_cast<float>((1 + slack) * (bounds.box.size().length() / 2 + error));
    const EmissionCone& cone = bounds.cone;
    for (std::size_t k = 0; k < 3; ++k)
        node.axis[k] = static_cast<float>(cone.axis[static_cast<int>(k)]);
    const double spread = std::min(pi, cone.spread + 4 * slack);
    node.cos_spread = static_cast<float>(std::cos(spread));
    node.sin_spread = static_cast<float>(std::sin(spread));
    node.cos_emission =
        static_cast<float>(std::cos(std::min(pi, cone.emission + 4 * slack)) - slack);
    node.intensity = static_cast<float>(bounds.intensity);
    node.two_sided = cone.two_sided;
    return node;
}

}  // namespace etalon
