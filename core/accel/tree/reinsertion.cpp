#include "core/accel/tree/reinsertion.h"

#include <algorithm>
#include <numeric>

#include "core/accel/tree/linked_tree.h"

namespace etalon {
namespace {

using Index = LinkedTree::Index;

/// Searches the cheapest places of nodes, and moves them there.
class Reinsertion {
  public:
    explicit Reinsertion(LinkedTree& tree) : tree_(tree) {}

    /// Moves the larger half of the nodes, the largest first: of the smaller ones, mostly leaves,
    /// nearly all are in their places already. Returns the new surface divided by the old one.
    double move_larger_half() {
        const double before = tree_.surface();
        for (const Index node : larger_half()) {
            if (is_movable(node)) move(node);
        }
        return tree_.surface() / before;
    }

  private:
    /// A place beside a node that is to be tried, as are those below it.
    struct Place {
        Index node;
        float united;  ///< half the surface area of the node's box with the one to be placed
        float growth;  ///< of half the surface area of all nodes above, if it is placed here
    };

    std::vector<Index> larger_half() const {
        std::vector<float> areas;
        for (const LinkedTree::Node& node : tree_.nodes()) areas.push_back(node.bounds.half_area());
        std::vector<Index> order(areas.size());
        std::iota(order.begin(), order.end(), Index{0});
        std::ranges::stable_sort(order, std::ranges::greater(), [&](Index i) { return areas[i]; });
        order.resize(order.size() / 2);
        return order;
    }

    bool is_movable(Index node) const {
        const Index parent = tree_[node].parent;
        return parent != LinkedTree::none && tree_[parent].parent != LinkedTree::none;
    }

    void move(Index node) {
        const Index sibling = tree_.detach(node);
        const Index place = cheapest_place(node, sibling);
        tree_.attach(node, tree_.may_attach(node, place) ? place : sibling);
    }

    /// Bounds the time of a search, which finds what is cheap early.
    static constexpr int most_places = 256;

    /// Searches from the root, by branch and bound: below a node no place costs less than the
    /// growth of it and those above, and the surface of the box itself. Prefers the old place
    /// unless another is cheaper by more than roundings.
    Index cheapest_place(Index node, Index old_place) {
        const Bounds box = tree_[node].bounds;
        const float own = box.half_area();
        float least = tree_.growth(old_place, box) * (1 - 0x1p-12F);
        Index cheapest = old_place;
        const LinkedTree::Node& root = tree_[0];
        places_.clear();
        push_children(root, united(root.bounds, box).half_area() - root.bounds.half_area(), box);
        for (int tried = 0; !places_.empty() && tried < most_places; ++tried) {
            const Place place = places_.back();
            places_.pop_back();
            if (place.growth + own >= least) continue;
            if (place.growth + place.united < least) {
                least = place.growth + place.united;
                cheapest = place.node;
            }
            const LinkedTree::Node& there = tree_[place.node];
            if (there.is_lowest()) continue;
            const float growth = place.growth + place.united - there.bounds.half_area();
            if (growth + own < least) push_children(there, growth, box);
        }
        return cheapest;
    }

    /// The child that grows less is tried first.
    void push_children(const LinkedTree::Node& parent, float growth, const Bounds& box) {
        const auto place = [&](int i) {
            const Index child = parent.children[i];
            return Place{child, united(tree_[child].bounds, box).half_area(), growth};
        };
        const auto grows = [&](const Place& p) {
            return p.united - tree_[p.node].bounds.half_area();
        };
        const Place left = place(0), right = place(1);
        const bool left_first = grows(left) < grows(right);
        places_.push_back(left_first ? right : left);
        places_.push_back(left_first ? left : right);
    }

    LinkedTree& tree_;
    std::vector<Place> places_;  ///< to be tried, the next one last
};

/// Returns whether most boxes of leaves differ in size by much: judges by the deciles of a sample.
bool sizes_differ(const BvhTree& tree) {
    constexpr std::size_t sample = 1024;
    constexpr float ratio = 64;
    std::vector<float> areas;
    const std::size_t stride = tree.nodes.size() / sample + 1;
    for (std::size_t i = 2; i < tree.nodes.size(); i += stride) {
        if (tree.nodes[i].is_leaf()) areas.push_back(half_area(tree.nodes[i].box));
    }
    std::ranges::sort(areas);
    const std::size_t tenth = areas.size() / 10;
    return tenth > 0 && areas[areas.size() - tenth] > ratio * ratio * areas[tenth];
}

}  // namespace

BvhTree reinserted(BvhTree tree) {
    constexpr std::size_t most_nodes = 1 << 17;
    constexpr int most_rounds = 8;
    constexpr double settled = 0.998;
    if (!sizes_differ(tree)) return tree;
    LinkedTree top(tree, most_nodes);
    Reinsertion reinsertion(top);
    for (int round = 0; round < most_rounds; ++round) {
        if (reinsertion.move_larger_half() > settled) break;
    }
    return top.whole();
}

}  // namespace etalon
