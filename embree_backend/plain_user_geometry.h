#pragma once

#include "core/intersect/intersector.h"
#include "embree_backend/device.h"

namespace etalon {

/// The backend `embree-user`: one Embree user geometry with one primitive per callback, as in
/// Embree's documentation. It is the independent check of the accelerators: it shares no hierarchy,
/// traversal, boxes or list of primitives with the project's trees, clusters and grids, so that a
/// primitive or a piece of a box that they lose is not lost here. It shares the kernels, the rule
/// for ties and the normalized space of the rays with all backends.
class PlainUserGeometry final : public Intersector {
  public:
    /// Throws as EmbreeDevice does. For `of_scene` see SceneDevice.
    explicit PlainUserGeometry(const Geometry& geometry, const SceneDevice* of_scene = nullptr);

    std::string isa() const override { return device_->isa(); }

  protected:
    std::size_t own_bytes() const override { return device_.bytes(); }
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    SceneDevice device_;
    EmbreeOwned<RTCScene> embree_scene_;
};

}  // namespace etalon
