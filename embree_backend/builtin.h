#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/intersect/intersector.h"
#include "core/numerics/affine.h"
#include "embree_backend/device.h"
#include "embree_backend/primitive_ids.h"
#include "embree_backend/user_primitives.h"

namespace etalon {

/// The backend `embree-builtin`: Embree's own float triangles, quads, spheres and instances, as the
/// baseline in speed and in accuracy. One-sided primitives, and those for which Embree has no
/// geometry, are tested as in the backend `embree`; so are instances of objects that have any.
class EmbreeBuiltin final : public Intersector {
  public:
    enum class Traversal {
        fast,
        robust,  ///< RTC_SCENE_FLAG_ROBUST: fewer leaks between triangles, 5 to 40 % slower
    };

    /// Throws as EmbreeDevice does. For `of_scene` see SceneDevice.
    explicit EmbreeBuiltin(const Geometry& geometry, Traversal traversal = Traversal::fast,
                           const SceneDevice* of_scene = nullptr);

    /// Returns whether Embree has a geometry for any of the primitives.
    static bool has_own_kernels(const Geometry& geometry);

    std::string isa() const override { return device_->isa(); }

  protected:
    std::size_t own_bytes() const override;
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override;
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override;

  private:
    const EmbreeBuiltin& object_of(const Instance& instance) const;

    /// Returns the map that Embree applies, from the object's normalized space to this one. Nothing
    /// if not all of the instance is Embree's, or if its floats cannot invert the map.
    std::optional<Affine> embree_map(const Instance& instance) const;

    /// Geometry numbers are in the order: those of others_, of ids_, of instances_.
    void attach_shapes(std::map<RTCGeometryType, std::vector<std::uint32_t>>&& by_type);
    void attach_instance(std::uint32_t item, const Affine& map);

    SceneDevice device_;
    float margin_ = 0;                      ///< by which rays are shortened: see margin_among()
    std::vector<PrimitiveIds> ids_;         ///< for each geometry of Embree's own shapes
    std::vector<std::uint32_t> instances_;  ///< items that are Embree's own instances
    UserPrimitives others_;
    EmbreeOwned<RTCScene> embree_scene_;
};

}  // namespace etalon
