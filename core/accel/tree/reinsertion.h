#pragma once

#include "core/accel/tree/builder.h"

namespace etalon {

/// Moves subtrees of a tree to where they enlarge the boxes above them least (Bittner, Hapala &
/// Havran 2013, "Fast Insertion-Based Optimization of Bounding Volume Hierarchies"). This gains
/// much where the leaves' sizes differ by orders of magnitude, as those of instances may, and
/// next to nothing elsewhere, where the tree is returned as it is. What is below the 2^17 largest
/// nodes moves as a whole. Runs on one thread.
BvhTree reinserted(BvhTree tree);

}  // namespace etalon
