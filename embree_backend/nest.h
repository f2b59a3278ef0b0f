#pragma once

#include <memory>

#include "core/intersect/instance_bounds.h"
#include "embree_backend/user_primitives.h"

namespace etalon {

/// The boxes of instances in double, for nests at any depth of one scene.
struct FineBoxes {
    FineBoxes(const Geometry& geometry, const NormalizedSpace& space);

    /// Whether the boxes hold all that the ray can hit: false if it starts far from the scene.
    bool hold_for(const Ray& ray) const;

    Vec3 centre;              ///< of the scene
    double scale;             ///< of its normalized space
    std::vector<Box3> boxes;  ///< one for each instance
};

/// Instances so small, and so near each other, that the padding of Embree's float boxes would be
/// most of theirs: an Embree scene in a normalized space of its own, which is a primitive of the
/// scene that it is part of. It may have nests within.
class Nest {
  public:
    /// `items`: the instances' numbers among the geometry's items, ascending.
    Nest(const EmbreeDevice& device, const Geometry& geometry, const Intersector& instances,
         const std::shared_ptr<const FineBoxes>& fine, std::vector<std::uint32_t> items);

    /// Offers `nearest` what the ray may hit of its instances.
    void offer(const RayQuery& query, NearestHit& nearest) const;
    bool occludes(const RayQuery& query) const;

    std::size_t memory_bytes() const {
        return items_.capacity() * sizeof(std::uint32_t) + primitives_.memory_bytes();
    }

  private:
    /// Whether its boxes are good enough for the ray; if not, each instance is to be asked.
    bool resolves(const Ray& ray) const;

    const Intersector& instances_;
    std::shared_ptr<const FineBoxes> fine_;
    std::vector<std::uint32_t> items_;
    NormalizedSpace space_;
    UserPrimitives primitives_;
    EmbreeOwned<RTCScene> embree_scene_;
};

/// Size of the smallest nests, in the scene's normalized space: rays from anywhere in the scene are
/// resolved there.
inline constexpr double smallest_nest = 0x1p-20;

/// Instances that are worth a nest.
struct FoundNest {
    Box3f box;
    std::vector<std::uint32_t> items;  ///< ascending
};

/// Finds nests among the primitives of a scene or of a nest that no filter is for: none smaller
/// than `least`, in the space of their boxes.
std::vector<FoundNest> find_nests(const std::vector<BoundedPrimitive>& singles, float least);

}  // namespace etalon
