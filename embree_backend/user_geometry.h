#pragma once

#include "core/intersect/intersector.h"
#include "embree_backend/device.h"
#include "embree_backend/user_primitives.h"

namespace etalon {

/// The backend `embree`: Embree's builder and traversal with the project's kernels, so that its
/// hits are those of every other exact backend to the last bit.
class EmbreeUserGeometry final : public Intersector {
  public:
    /// Throws as EmbreeDevice does. For `of_scene` see SceneDevice.
    explicit EmbreeUserGeometry(const Geometry& geometry, const SceneDevice* of_scene = nullptr);

    std::string isa() const override { return device_->isa(); }

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    SceneDevice device_;
    std::vector<UserView> objects_;
    UserPrimitives primitives_;
    EmbreeOwned<RTCScene> embree_scene_;
};

}  // namespace etalon
