#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

/// A hit in a scene of a physical look. The normals are on the side that the format calls the
/// front, wherever the ray came from.
struct PhysicalSurface {
    SurfacePoint point;  ///< with the shape's own normals
    const SurfaceBinding* binding;
    Vec3 ng, ns;
};

PhysicalSurface physical_surface(const Scene& scene, const Ray& ray, const Hit& hit);

/// Replaces the coordinates of a triangle's own by those that its mesh gives to the corners, if the
/// mesh has some: see SurfaceBinding::uv_offset. `geometry` is that in which the primitive is.
Parametrization with_coordinates_of_mesh(const Geometry& geometry, std::uint32_t primitive,
                                         std::uint32_t uv_offset, const Parametrization& own);

/// Surface coordinates of the format at the hit: those of a mesh where it has its own.
Parametrization physical_parametrization(const Scene& scene, const PhysicalSurface& at);

}  // namespace etalon
