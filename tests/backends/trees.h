// Boxes of many kinds to build trees of, and properties that any tree has.
#pragma once

#include <span>
#include <vector>

#include "core/accel/tree/builder.h"

namespace etalon {

using Primitives = std::vector<BoundedPrimitive>;

/// Returns `count` primitives, always the same.
using Cast = Primitives (*)(std::size_t count);

/// At random places in a cube, triangles and shapes of all kinds.
Primitives scattered(std::size_t count);
Primitives of_all_kinds(std::size_t count);

/// Two shapes at the same positions.
Primitives in_pairs(std::size_t count);

/// Of sizes from 1e-6 to 1 about one centre.
Primitives concentric(std::size_t count);

/// Instances of sizes from 1e-6 to 1 in rings about one centre, each a few times as far away as it
/// is large.
Primitives nested(std::size_t count);

/// Returns all of these, and some on which building might fail.
std::span<const Cast> all_casts();

/// Counts of a traversal of the whole tree.
class Inspection {
  public:
    Inspection(const BvhTree& tree, const Primitives& primitives, const BvhConfig& config = {});

    bool each_once() const;

  private:
    void visit(const BvhNode& node, int level);
    void visit_leaf(const BvhNode& node);

    const BvhTree& tree_;
    const Primitives& primitives_;
    std::uint32_t max_leaf_;

  public:
    std::vector<int> seen;  ///< occurrences of each primitive
    std::size_t nodes = 0, leaves = 0;
    std::size_t outside_parent = 0, too_large = 0, of_other_kind = 0, loose_leaves = 0;
    int depth = 0;
    double surface = 0;  ///< sum of half the surface area of all inner nodes
};

void require_sound(const BvhTree& tree, const Primitives& primitives, const BvhConfig& config = {});

bool same(const BvhTree& a, const BvhTree& b);

}  // namespace etalon
