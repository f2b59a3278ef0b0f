#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Half the surface; 0 for an empty box.
inline float half_area(const Box3f& box) {
    if (box.isEmpty()) return 0;
    const Vec3f s = box.size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// A node of the binary tree that building makes. The two children of an inner node stand side by
/// side.
struct BvhNode {
    Box3f box;            ///< bounds in normalized space, padded: contains all below
    std::uint32_t first;  ///< inner: index of the first child; leaf: of the first primitive
    std::uint32_t count;  ///< primitives of a leaf; 0 for an inner node

    bool is_leaf() const { return count != 0; }
};

}  // namespace etalon
