#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "native_accel/bvh/float4.h"
#include "native_accel/bvh/node.h"

namespace etalon {

/// Four children and their boxes, two cache lines.
struct alignas(64) WideNode {
    std::array<Float4, 6> planes;        ///< min x, y, z, max x, y, z of the four boxes
    std::array<std::uint32_t, 4> first;  ///< of a leaf's primitives; else the child's node
    std::array<std::uint32_t, 4> count;  ///< primitives of a leaf; 0 for an inner node
};

static_assert(sizeof(WideNode) == 128);

/// Places a binary tree's nodes four to one, opening the largest first. Lanes without a child hold
/// a box that nothing enters. Empty for an empty tree.
std::vector<WideNode> widen(const std::vector<BvhNode>& nodes);

}  // namespace etalon
