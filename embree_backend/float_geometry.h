#pragma once

#include <optional>
#include <vector>

#include "core/intersect/normalized_space.h"
#include "core/scene/geometry.h"
#include "embree_backend/device.h"

namespace etalon {

/// Returns Embree's type for a primitive if Embree has one that is hit on the same sides.
std::optional<RTCGeometryType> embree_type_of(const Geometry& geometry,
                                              const NormalizedSpace& space,
                                              std::uint32_t primitive);

/// Makes Embree's own geometries from a scene's primitives, as floats in normalized space.
class FloatGeometry {
  public:
    FloatGeometry(const EmbreeDevice& device, const Geometry& geometry,
                  const NormalizedSpace& space);

    /// Makes a geometry of the primitives `ids`, all of that type, in this order. Throws as
    /// EmbreeDevice does.
    EmbreeOwned<RTCGeometry> make(RTCGeometryType type,
                                  const std::vector<std::uint32_t>& ids) const;

  private:
    void fill_triangles(RTCGeometry geometry, const std::vector<std::uint32_t>& ids) const;
    void fill_quads(RTCGeometry geometry, const std::vector<std::uint32_t>& ids) const;
    void fill_spheres(RTCGeometry geometry, const std::vector<std::uint32_t>& ids) const;

    template <class Shape>
    decltype(auto) get(std::uint32_t id) const {
        return geometry_.get<Shape>(geometry_.primitives[id]);
    }

    const EmbreeDevice& device_;
    const Geometry& geometry_;
    const NormalizedSpace& space_;
    EmbreeOwned<RTCBuffer> vertices_;  ///< all of the scene's, so that indices do not change
};

}  // namespace etalon
