#pragma once

#include <vector>

#include "core/intersect/intersector.h"
#include "core/intersect/ray_group.h"

namespace etalon {

/// No structure at all. Even the shortcuts of the normalized space are left out: to this backend
/// every primitive is unbounded, so it is what the others are checked against. Of many rays, those
/// that go nearly the same way pass what is far from all of them together.
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
    template <class Visit>
    void for_each_near(const RayGroup& group, const Visit& visit) const;

    std::vector<Box3> boxes_;  ///< of the primitives
};

}  // namespace etalon
