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
    /// Nodes follow their parents, the first child at once.
    struct Node {
        etalon::Box3f box;
        std::uint32_t begin, end;  ///< in primitives_; empty but for leaves
        std::uint32_t next;        ///< node after all those below this one
    };

    void build(std::span<etalon::BoundedPrimitive> primitives, std::uint32_t first);

    /// Calls offer(primitive) for those that the ray could hit up to tmax(), until that is true.
    template <class Tmax, class Offer>
    bool traverse(const etalon::RayQuery& query, const etalon::NormalizedRay& local,
                  const Tmax& tmax, const Offer& offer) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> primitives_;  ///< and instances
};

}  // namespace laboratory
