#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "native_accel/bvh/builder.h"

namespace etalon {

/// Four floats side by side. GCC's and Clang's vectors: every x86-64 and arm64 has instructions for
/// them, so there is nothing to choose at run time.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 broadcast(float x) {
    return Float4{x, x, x, x};
}
inline Float4 max(Float4 a, Float4 b) {
    return a > b ? a : b;
}
inline Float4 min(Float4 a, Float4 b) {
    return a < b ? a : b;
}

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
