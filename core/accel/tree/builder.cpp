#include "core/accel/tree/builder.h"

#include <algorithm>

#include "core/accel/tree/parallel_partition.h"
#include "core/accel/tree/subtree.h"
#include "core/accel/tree/subtree_merge.h"
#include "core/parallel/large_pages.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

using Primitives = std::span<BoundedPrimitive>;

ShapeKind commonest_kind(const BoundsSummary& all) {
    const auto most = std::max_element(all.of_kind.begin(), all.of_kind.end());
    return static_cast<ShapeKind>(most - all.of_kind.begin());
}

/// Frees the memory of a vector, to make room for the nodes.
template <class Vector>
void release(Vector& v) {
    Vector().swap(v);
}

/// Divides large sets with all threads together, and builds each small one on a single thread.
class Builder {
  public:
    Builder(const BvhConfig& config, const LeafWeights& weights, std::vector<std::uint32_t>& ids)
        : config_(config), weights_(weights), ids_(ids) {}

    /// Builds the tree of a set that starts at index `first` of the whole. `spare` has the same
    /// size.
    std::unique_ptr<Part> build(const PrimitiveSet& set, Primitives spare, std::size_t first,
                                int depth) const {
        auto part = std::make_unique<Part>();
        part->box = set.bounds.box();
        if (set.size() <= std::max<std::size_t>(config_.serial_below, config_.max_leaf)) {
            part->nodes = SubtreeBuilder(config_, weights_, ids_.data()).build(set, first, depth);
            return part;
        }
        const bool in_halves = depth >= bvh_heuristic_depth;
        const SplitResult d = split_large(set, spare, in_halves, config_, weights_);
        const auto& left = d.halves.left;
        const auto& right = d.halves.right;
        const std::size_t middle = left.size();
        parallel_invoke([&] { part->left = build(left, d.spare.first(middle), first, depth + 1); },
                        [&] {
                            part->right =
                                build(right, d.spare.subspan(middle), first + middle, depth + 1);
                        });
        return part;
    }

  private:
    const BvhConfig& config_;
    const LeafWeights& weights_;
    std::vector<std::uint32_t>& ids_;
};

}  // namespace

BvhTree build_bvh(std::vector<BoundedPrimitive> primitives, const BvhConfig& config) {
    if (primitives.empty()) return {};
    BvhTree tree;
    tree.ids.resize(primitives.size());
    const BoundsSummary all = summarize_bounds(primitives);
    const LeafWeights weights(config.leaf_costs, commonest_kind(all));
    std::vector<BoundedPrimitive, LargePages<BoundedPrimitive>> spare(primitives.size());
    const auto parts = Builder(config, weights, tree.ids).build(all.set, spare, 0, 0);
    release(spare);
    release(primitives);
    tree.nodes = merge_subtrees(*parts);
    return tree;
}

}  // namespace etalon
