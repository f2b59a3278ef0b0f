#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

/// A hit with its material, and its normals turned to the side that the ray came from.
struct SurfaceInteraction {
    SurfacePoint surface;
    const Material* material;  ///< null in a scene with physical materials
    bool entering;             ///< the ray came from in front of the surface
    Vec3 ng;                   ///< geometric normal, on the ray's side
    Vec3 ns;                   ///< shading normal, on the same side of the surface as `ng`
};

SurfaceInteraction surface_interaction(const Scene& scene, const Ray& ray, const Hit& hit);

/// Returns (u, v), dpdu and dpdv at the hit. They are not stored in it, so that shading that needs
/// none of them does not pay for them.
Parametrization parametrization(const Scene& scene, const SurfaceInteraction& at);

}  // namespace etalon
