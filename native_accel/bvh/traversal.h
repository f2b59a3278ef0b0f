// How a ray walks a binary BVH, apart from what is done at the leaves.
#pragma once

#include <array>
#include <cmath>

#include "core/intersect/frame.h"
#include "native_accel/bvh/builder.h"

namespace etalon {

/// Slab tests in float. The boxes' padding (Frame::box) makes up for every rounding here, including
/// that of the reciprocal.
class SlabTest {
  public:
    explicit SlabTest(const FrameRay& ray) : origin_(ray.origin) {
        for (int k = 0; k < 3; ++k) {
            // No smaller than 2^-40 of the largest component: no infinity, no NaN, and over the few
            // units a ray can travel in the frame a drift far below the padding.
            const float d = ray.direction[k];
            const float clamped = std::abs(d) < 0x1p-40F ? std::copysign(0x1p-40F, d) : d;
            reciprocal_[k] = 1.0F / clamped;
        }
    }

    /// Where the ray enters the box, within [tmin, tmax]; infinity if it does not.
    float entry(const Box3f& box, float tmin, float tmax) const {
        for (int k = 0; k < 3; ++k) {
            const float a = (box.min[k] - origin_[k]) * reciprocal_[k];
            const float b = (box.max[k] - origin_[k]) * reciprocal_[k];
            tmin = std::max(tmin, std::min(a, b));
            tmax = std::min(tmax, std::max(a, b));
        }
        return tmin <= tmax ? tmin : std::numeric_limits<float>::infinity();
    }

  private:
    Vec3f origin_, reciprocal_;
};

/// Visits leaves from near to far. leaf(first, count) tests a range of BvhTree::ids and returns the
/// new tmax in the frame; anything below tmin ends the walk.
template <class Leaf>
void traverse(const BvhTree& tree, const FrameRay& ray, float tmin, float tmax, const Leaf& leaf) {
    struct Pending {
        std::uint32_t node;
        float entry;
    };
    std::array<Pending, bvh_max_depth + 1> stack;
    const SlabTest slabs(ray);
    std::size_t height = 0;
    stack[height++] = {0, slabs.entry(tree.nodes[0].box, tmin, tmax)};
    while (height > 0) {
        Pending current = stack[--height];
        if (current.entry > tmax) continue;
        const BvhNode* node = &tree.nodes[current.node];
        while (!node->is_leaf()) {
            Pending near{node->first, slabs.entry(tree.nodes[node->first].box, tmin, tmax)};
            Pending far{node->first + 1, slabs.entry(tree.nodes[node->first + 1].box, tmin, tmax)};
            if (far.entry < near.entry) std::swap(near, far);
            if (near.entry > tmax) break;
            if (far.entry <= tmax) stack[height++] = far;
            node = &tree.nodes[near.node];
        }
        if (!node->is_leaf()) continue;
        tmax = leaf(node->first, node->count);
        if (tmax < tmin) return;
    }
}

}  // namespace etalon
