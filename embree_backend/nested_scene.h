#pragma once

#include <memory>

#include "core/intersect/instance_bounds.h"
#include "embree_backend/user_primitives.h"

namespace etalon {

/// What the nested scenes of one scene share.
struct NestedSceneData {
    NestedSceneData(const Geometry& geometry, const Intersector& instances,
                    const NormalizedSpace& space);

    /// Returns whether the boxes contain all that the ray can hit: not if it starts far from the
    /// scene.
    bool hold_for(const Ray& ray) const;

    std::size_t memory_bytes() const {
        return boxes.capacity() * sizeof(Box3) + objects.capacity() * sizeof(ObjectSpace);
    }

    Vec3 centre;                       ///< of the scene
    double scale;                      ///< of its normalized space
    LargeVector<Box3> boxes;           ///< one for each instance, in double
    std::vector<ObjectSpace> objects;  ///< spaces of the intersectors of all objects
};

/// An Embree scene of instances that are so small, and so near each other, that the padding of
/// float boxes would be most of theirs in the scene around them. It has a normalized space of its
/// own, is one primitive of that scene, and may contain further nested scenes.
class NestedScene {
  public:
    /// `objects` is as for UserPrimitives. `items` are the numbers of the instances among the
    /// geometry's items, ascending.
    NestedScene(const EmbreeDevice& device, const Geometry& geometry, const Intersector& instances,
                const std::vector<UserView>* objects,
                const std::shared_ptr<const NestedSceneData>& shared,
                std::vector<std::uint32_t> items);

    /// Offers `nearest` those of its instances that the ray may hit.
    void offer(const RayQuery& query, NearestHit& nearest) const;
    bool occludes(const RayQuery& query) const;

    std::size_t memory_bytes() const {
        return items_.capacity() * sizeof(std::uint32_t) + primitives_.memory_bytes();
    }

  private:
    /// Returns whether its boxes are valid for the ray. If not, every instance must be tested.
    bool resolves(const Ray& ray) const;

    const Intersector& instances_;
    std::shared_ptr<const NestedSceneData> shared_;
    std::vector<std::uint32_t> items_;
    NormalizedSpace space_;
    UserPrimitives primitives_;
    EmbreeOwned<RTCScene> embree_scene_;
};

/// Size of the smallest nested scenes in the normalized space of the whole scene. At this size rays
/// from anywhere in the scene still have valid boxes.
inline constexpr double smallest_nested_scene = 0x1p-20;

/// Instances that become a nested scene.
struct NestedSceneItems {
    Box3f box;
    std::vector<std::uint32_t> items;  ///< ascending
};

/// Finds instances that should become nested scenes among `singles`, the primitives of a scene or
/// of a nested scene that have no filter. None is smaller than `least` in the space of their boxes.
std::vector<NestedSceneItems> find_nested_scenes(const std::vector<BoundedPrimitive>& singles,
                                                 float least);

}  // namespace etalon
