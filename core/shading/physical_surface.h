#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

/// A hit in a scene with physical materials. The normals are on the side that the format calls the
/// front, wherever the ray came from.
struct PhysicalSurface {
    SurfacePoint point;  ///< with the shape's own normals
    const SurfaceBinding* binding;
    Vec3 ng, ns;
};

PhysicalSurface physical_surface(const Scene& scene, const Ray& ray, const Hit& hit);

/// Returns whether a surface has the null material, through which rays pass unchanged.
bool has_null_material(const Scene& scene, const PhysicalSurface& at);

/// Replaces a triangle's own coordinates by those that its mesh has at the vertices, if any: see
/// SurfaceBinding::uv_offset. `geometry` is the one that holds the primitive.
Parametrization with_coordinates_of_mesh(const Geometry& geometry, std::uint32_t primitive,
                                         std::uint32_t uv_offset, const Parametrization& own);

/// Returns the format's surface coordinates at the hit: those of the mesh where it has any.
Parametrization physical_parametrization(const Scene& scene, const PhysicalSurface& at);

}  // namespace etalon
