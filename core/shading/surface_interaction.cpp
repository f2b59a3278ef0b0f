#include "core/shading/surface_interaction.h"

#include "core/intersect/kernels.h"

namespace etalon {

SurfaceInteraction surface_interaction(const Scene& scene, const Ray& ray, const Hit& hit) {
    SurfaceInteraction at{surface_at(scene.geometry, ray, hit), nullptr, false, Vec3(0), Vec3(0)};
    const SurfacePoint& p = at.surface;
    const auto* const look = std::get_if<WhittedLook>(&scene.look);
    at.material = look ? &look->materials[p.material] : nullptr;
    at.entering = ray.direction.dot(p.normal) < 0;
    at.ng = at.entering ? p.normal : -p.normal;
    // An interpolated normal may point away from the ray. Which side of the surface is lit is then
    // still decided by the geometric normal alone.
    at.ns = at.ng.dot(p.shading_normal) > 0 ? p.shading_normal : -p.shading_normal;
    return at;
}

Parametrization parametrization(const Scene& scene, const SurfaceInteraction& at) {
    return parametrization_at(scene.geometry, at.surface);
}

}  // namespace etalon
