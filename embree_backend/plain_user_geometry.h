#pragma once

#include "core/intersect/intersector.h"
#include "embree_backend/device.h"

namespace etalon {

/// The backend `embree-user`: one Embree user geometry with one primitive a callback, as Embree's
/// documentation shows. It is the independent witness against the accelerators: its hierarchy,
/// traversal, boxes and list of primitives are not those that the project's trees, clusters and
/// grids are made from, so that a primitive or a piece of a box which they lose is not lost here.
/// The kernels, the rule for ties and the normalized space of the rays are those of all backends.
class PlainUserGeometry final : public Intersector {
  public:
    /// Throws as EmbreeDevice does.
    explicit PlainUserGeometry(const Geometry& geometry);

    std::string isa() const override { return device_.isa(); }

  protected:
    std::size_t own_bytes() const override { return device_.bytes(); }
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    EmbreeDevice device_;
    EmbreeOwned<RTCScene> embree_scene_;
};

}  // namespace etalon
