#pragma once

#include <vector>

#include "core/intersect/intersector.h"
#include "embree_backend/device.h"
#include "embree_backend/primitive_ids.h"
#include "embree_backend/user_primitives.h"

namespace etalon {

/// The backend `embree-builtin`: Embree's own float triangles, quads and spheres, as the baseline
/// in speed and in accuracy. One-sided primitives, and what Embree has no geometry for, are tested
/// as by the backend `embree`.
class EmbreeBuiltin final : public Intersector {
  public:
    enum class Traversal {
        fast,
        robust,  ///< RTC_SCENE_FLAG_ROBUST: fewer leaks between triangles, 5 to 40 % slower
    };

    /// Throws as EmbreeDevice does.
    explicit EmbreeBuiltin(const Geometry& geometry, Traversal traversal = Traversal::fast);

    /// Whether Embree has a geometry for any of the primitives.
    static bool has_own_kernels(const Geometry& geometry);

    std::string isa() const override { return device_.isa(); }

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    EmbreeDevice device_;
    std::vector<PrimitiveIds> ids_;  ///< for each geometry of Embree's own; the next is others_
    UserPrimitives others_;
    EmbreeOwned<RTCScene> embree_scene_;
};

}  // namespace etalon
