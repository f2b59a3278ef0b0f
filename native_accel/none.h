#pragma once

#include "core/intersect/intersector.h"

namespace etalon {

/// No structure at all. Even the shortcuts of the normalized space are left out: to this backend
/// every primitive is unbounded, so it is what the others are checked against.
class None final : public Intersector {
  public:
    explicit None(const Geometry& geometry);

    using Intersector::closest;
    using Intersector::occluded;

    /// Goes from primitive to primitive rather than from ray to ray.
    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override;

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const RayQuery&, const NormalizedRay&, NearestHit&) const override {}
    bool occluded_bounded(const RayQuery&, const NormalizedRay&) const override { return false; }

  private:
    Hit with_instances(const Ray& ray, const Hit& hit) const;
    bool instances_occlude(const Ray& ray) const;
    template <class Visit>
    bool for_each_instance(const Visit& visit) const;
};

}  // namespace etalon
