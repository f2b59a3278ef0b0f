#pragma once

#include "core/intersect/intersector.h"

namespace etalon {

/// Backend without any structure. It does not even use the shortcuts of normalized space: every
/// primitive is unbounded to it, so it is the reference for the others.
class None final : public Intersector {
  public:
    explicit None(const Geometry& geometry);

    using Intersector::closest;
    using Intersector::occluded;

    /// Loops over primitives outside and over rays inside.
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
