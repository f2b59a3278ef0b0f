// How a ray walks a four-wide BVH, apart from what is done at the leaves.
#pragma once

#include <cmath>
#include <limits>

#include "core/intersect/frame.h"
#include "native_accel/bvh/wide_node.h"

namespace etalon {

/// Slab tests of four boxes in float. The boxes' padding (Frame::box) makes up for every rounding
/// here, including that of the reciprocal.
class SlabTest {
  public:
    explicit SlabTest(const FrameRay& ray) {
        for (int k = 0; k < 3; ++k) {
            // No smaller than 2^-40 of the largest component: no infinity times zero, and over the
            // few units a ray can travel in the frame a drift far below the padding.
            const float d = ray.direction[k];
            const float clamped = std::abs(d) < 0x1p-40F ? std::copysign(0x1p-40F, d) : d;
            origin_[k] = broadcast(ray.origin[k]);
            reciprocal_[k] = broadcast(1.0F / clamped);
            near_[k] = clamped > 0 ? k : 3 + k;
        }
    }

    /// Where the ray enters each box within [tmin, tmax]; infinity where it does not.
    Float4 entries(const WideNode& node, Float4 tmin, Float4 tmax) const {
        for (int k = 0; k < 3; ++k) {
            const int far = near_[k] < 3 ? 3 + k : k;
            tmin = max(tmin, (node.planes[near_[k]] - origin_[k]) * reciprocal_[k]);
            tmax = min(tmax, (node.planes[far] - origin_[k]) * reciprocal_[k]);
        }
        return tmin <= tmax ? tmin : broadcast(std::numeric_limits<float>::infinity());
    }

  private:
    std::array<Float4, 3> origin_, reciprocal_;
    std::array<int, 3> near_;
};

/// What is still to be visited: nodes and leaves, the next one last.
class TraversalStack {
  public:
    struct Entry {
        float t;  ///< where the ray enters
        std::uint32_t first, count;
    };

    bool empty() const { return height_ == 0; }
    Entry pop() { return entries_[--height_]; }
    void push(const Entry& e) { entries_[height_++] = e; }

    /// Adds the children that are entered, the nearest last.
    void push_sorted(const WideNode& node, Float4 t) {
        const std::size_t bottom = height_;
        for (std::size_t lane = 0; lane < 4; ++lane) {
            if (t[lane] == std::numeric_limits<float>::infinity()) continue;
            std::size_t place = height_++;
            for (; place > bottom && entries_[place - 1].t < t[lane]; --place) {
                entries_[place] = entries_[place - 1];
            }
            entries_[place] = {t[lane], node.first[lane], node.count[lane]};
        }
    }

  private:
    // Each level leaves at most three siblings behind.
    std::array<Entry, 3 * bvh_max_depth + 4> entries_;
    std::size_t height_ = 0;
};

/// Visits leaves from near to far. leaf(first, count, tmax) tests its primitives and returns the
/// new tmax in the frame; anything below tmin ends the walk. tmax must be finite.
template <class Leaf>
void traverse(const std::vector<WideNode>& nodes, const FrameRay& ray, float tmin, float tmax,
              const Leaf& leaf) {
    const SlabTest slabs(ray);
    TraversalStack stack;
    stack.push({tmin, 0, 0});
    while (!stack.empty()) {
        const TraversalStack::Entry next = stack.pop();
        if (next.t > tmax) continue;
        if (next.count == 0) {
            const WideNode& node = nodes[next.first];
            stack.push_sorted(node, slabs.entries(node, broadcast(tmin), broadcast(tmax)));
        } else {
            tmax = leaf(next.first, next.count, tmax);
            if (tmax < tmin) return;
        }
    }
}

}  // namespace etalon
