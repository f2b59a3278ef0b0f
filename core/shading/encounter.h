#pragma once

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

/// A hit seen from where the ray came.
struct Encounter {
    SurfacePoint surface;
    const Material& material;
    bool entering;  ///< the ray came from in front of the surface
    Vec3 facing;    ///< geometric normal, on the ray's side
    Vec3 normal;    ///< for shading, on the same side of the surface as `facing`
};

Encounter encounter(const Scene& scene, const Ray& ray, const Hit& hit);

/// Returns (u, v), dpdu and dpdv at the hit. Not stored in it: shading that needs none of them does
/// not pay for them.
Parametrization parametrization(const Scene& scene, const Encounter& at);

}  // namespace etalon
