#pragma once

#include <vector>

#include "core/intersect/intersector.h"
#include "embree_backend/device.h"
#include "embree_backend/primitive_ids.h"

namespace etalon {

/// Primitives of which Embree knows only the boxes: it finds the boxes that a ray meets, nearest
/// first, and the kernels decide. Its robust flag does nothing for these: that a float traversal
/// loses no hit is due to the padding of the boxes and to a tfar that is never below the best t.
class UserPrimitives {
  public:
    explicit UserPrimitives(const Scene& scene) : scene_(scene) {}
    UserPrimitives(const UserPrimitives&) = delete;
    UserPrimitives& operator=(const UserPrimitives&) = delete;

    /// Puts `primitives` into `target` as the geometry `geometry_id` and builds it, with whatever
    /// else is in it.
    void build(const EmbreeDevice& device, RTCScene target, unsigned geometry_id,
               std::vector<BoundedPrimitive> primitives);

    std::size_t memory_bytes() const { return ids_.memory_bytes(); }

  private:
    static void bounds(const RTCBoundsFunctionArguments* arguments);
    static void intersect(const RTCIntersectFunctionNArguments* arguments);
    static void occluded(const RTCOccludedFunctionNArguments* arguments);

    const Scene& scene_;
    PrimitiveIds ids_;
    std::vector<BoundedPrimitive> boxes_;  ///< while building
};

}  // namespace etalon
