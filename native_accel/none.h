#pragma once

#include "core/intersect/intersector.h"

namespace etalon {

/// No structure at all. Even the shortcuts of the normalized space are left out: to this backend
/// every primitive is unbounded, so it is what the others are checked against.
class None final : public Intersector {
  public:
    explicit None(const Geometry& geometry);
    std::size_t memory_bytes() const override;

    using Intersector::closest;
    using Intersector::occluded;

    /// Goes from primitive to primitive rather than from ray to ray.
    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override;

  protected:
    void closest_bounded(const RayQuery&, const NormalizedRay&, NearestHit&) const override {}
    bool occluded_bounded(const RayQuery&, const NormalizedRay&) const override { return false; }
};

}  // namespace etalon
