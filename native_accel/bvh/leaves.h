#pragma once

#include <vector>

#include "native_accel/bvh/builder.h"
#include "native_accel/bvh/triangle_filter.h"

namespace etalon {

/// The primitives of a tree's leaves. Those of a leaf of nothing but triangles are packed to be
/// filtered four at once; of others there is only the number.
class Leaves {
  public:
    Leaves() = default;

    /// Changes `first` and `count` of the tree's leaves to what visit() takes.
    Leaves(const Scene& scene, const Frame& frame, BvhTree& tree);

    /// Calls offer(id) for all primitives of a leaf that could be hit at t <= tmax, in the frame,
    /// for as long as it returns true.
    template <class Offer>
    void visit(std::uint32_t first, std::uint32_t count, const TriangleFilter& filter, float tmax,
               const Offer& offer) const {
        if ((count & packed) != 0) return visit_packed(first, count & ~packed, filter, tmax, offer);
        for (std::uint32_t i = first; i < first + count; ++i) {
            if (!offer(ids_[i])) return;
        }
    }

    std::size_t memory_bytes() const;

  private:
    /// Marks a count of triangle leaves instead of primitives.
    static constexpr std::uint32_t packed = 0x80000000U;

    template <class Offer>
    void visit_packed(std::uint32_t first, std::uint32_t count, const TriangleFilter& filter,
                      float tmax, const Offer& offer) const {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const TriangleLeaf& leaf = triangles_[i];
            const Mask4 candidates = filter.candidates(leaf, tmax);
            if (!any(candidates)) continue;
            for (std::uint32_t lane = 0; lane < TriangleLeaf::lanes; ++lane) {
                if (candidates[lane] != 0 && !offer(leaf.ids[lane])) return;
            }
        }
    }

    std::vector<TriangleLeaf> triangles_;
    std::vector<std::uint32_t> ids_;
};

}  // namespace etalon
