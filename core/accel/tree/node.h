#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns half the surface area; 0 for an empty box.
inline float half_area(const Box3f& box) {
    if (box.isEmpty()) return 0;
    const Vec3f s = box.size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// A node of the binary tree that the builder makes. The two children of an inner node are
/// adjacent.
struct BvhNode {
    Box3f box;            ///< padded bounds in normalized space, of all primitives below
    std::uint32_t first;  ///< index of an inner node's first child, or of a leaf's first primitive
    std::uint32_t count;  ///< primitives of a leaf; 0 for an inner node

    bool is_leaf() const { return count != 0; }
};

}  // namespace etalon
