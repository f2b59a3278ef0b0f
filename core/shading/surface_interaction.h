#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

/// A hit seen from where the ray came.
struct SurfaceInteraction {
    SurfacePoint surface;
    const Material* material;  ///< in the scene's look; null if that is a physical one
    bool entering;             ///< the ray came from in front of the surface
    Vec3 ng;                   ///< geometric normal, on the ray's side
    Vec3 ns;                   ///< shading normal, on the same side of the surface as `ng`
};

SurfaceInteraction surface_interaction(const Scene& scene, const Ray& ray, const Hit& hit);

/// Returns (u, v), dpdu and dpdv at the hit. Not stored in it: shading that needs none of them does
/// not pay for them.
Parametrization parametrization(const Scene& scene, const SurfaceInteraction& at);

}  // namespace etalon
