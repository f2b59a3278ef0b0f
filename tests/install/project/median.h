// A backend: a binary tree of boxes, each split at the median of its longest side.
#pragma once

#include "core/intersect/intersector.h"

namespace laboratory {

class Median final : public etalon::Intersector {
  public:
    explicit Median(const etalon::Geometry& geometry);

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const etalon::RayQuery& query, const etalon::NormalizedRay& local,
                         etalon::NearestHit& nearest) const override;
    bool occluded_bounded(const etalon::RayQuery& query,
                          const etalon::NormalizedRay& local) const override;

  private:
    /// A node. Nodes follow their parents, the first child immediately.
    struct Node {
        etalon::Box3f box;
        std::uint32_t begin, end;  ///< in primitives_; empty except for leaves
        std::uint32_t next;        ///< next node outside of this subtree
    };

    void build(std::span<etalon::BoundedPrimitive> primitives, std::uint32_t first);

    /// Calls offer(primitive) for those that the ray could hit up to tmax(), until it returns true.
    template <class Tmax, class Offer>
    bool traverse(const etalon::RayQuery& query, const etalon::NormalizedRay& local,
                  const Tmax& tmax, const Offer& offer) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> primitives_;  ///< and instances
};

}  // namespace laboratory
