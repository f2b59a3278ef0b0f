#include "core/accel/tree/subtree_merge.h"

#include <algorithm>

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// A part with the indices of its root and of the nodes below that.
struct Placed {
    const Part* part;
    std::size_t root, below;
};

class Placing {
  public:
    explicit Placing(const Part& root) { place(root, 0); }

    std::size_t size() const { return size_; }
    const std::vector<Placed>& parts() const { return parts_; }

  private:
    void place(const Part& part, std::size_t root) {
        const std::size_t below = size_;
        parts_.push_back({&part, root, below});
        size_ += part.left ? 2 : part.nodes.size() - 2;
        if (!part.left) return;
        place(*part.left, below);
        place(*part.right, below + 1);
    }

    std::size_t size_ = 2;
    std::vector<Placed> parts_;
};

void write(const Placed& placed, std::vector<BvhNode>& nodes) {
    const Part& part = *placed.part;
    const auto below = static_cast<std::uint32_t>(placed.below);
    if (part.left) {
        nodes[placed.root] = {part.box, below, 0};
        return;
    }
    const auto moved = [&](BvhNode node) {
        if (!node.is_leaf()) node.first += below - 2;
        return node;
    };
    nodes[placed.root] = moved(part.nodes[0]);
    std::transform(part.nodes.begin() + 2, part.nodes.end(), nodes.begin() + placed.below, moved);
}

}  // namespace

std::vector<BvhNode> merge_subtrees(const Part& root) {
    const Placing placing(root);
    std::vector<BvhNode> nodes(placing.size());
    parallel_for(placing.parts().size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) write(placing.parts()[i], nodes);
    });
    return nodes;
}

}  // namespace etalon
