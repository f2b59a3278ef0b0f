// Auxiliary features of an image: for denoisers, compositors, and reports on an accelerator. They
// are rendered with separate rays, which are not counted elsewhere.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "core/intersect/intersector.h"
#include "core/render/film.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

class PhysicalShading;

/// Means over the first samples of each pixel, at most 16. They are the image's own samples, so
/// that what is behind an edge has the same share. A miss counts as 0.
struct SurfaceMeans {
    Film albedo;  ///< diffuse + reflection + transmission of the material, each in [0, 1]
    Film normal;  ///< shading normal, unit, on the side of the surface that is seen
};

/// First hits of one ray through the centre of each pixel and of the lens, in rows from the top.
/// Rays pass surfaces of the null material.
struct CentreHits {
    std::vector<Vec3f> positions;           ///< 0 for a miss
    std::vector<float> depths;              ///< along the camera's axis; infinity for a miss
    std::vector<std::uint32_t> primitives;  ///< as in a Hit; no_index for a miss
    std::vector<std::uint32_t> instances;   ///< as in a Hit
    std::vector<TraversalCost> costs;       ///< as far as the backend counts
};

/// Surface coordinates at those hits, with their derivatives in world space; 0 for a miss.
struct CentreParametrizations {
    std::vector<Imath::V2f> uv;
    std::vector<Vec3f> dpdu, dpdv;
};

/// Renders the features of an image with these settings; nothing if `stop` was set meanwhile. All
/// are the same for any number of threads. `shading`: evaluates the materials of a physical look;
/// without it their albedo is 0.
std::optional<SurfaceMeans> surface_means(const Scene& scene, const Intersector& intersector,
                                          const RenderSettings& settings,
                                          const PhysicalShading* shading,
                                          const std::atomic<bool>* stop = nullptr);
std::optional<CentreHits> centre_hits(const Scene& scene, const Intersector& intersector,
                                      const RenderSettings& settings,
                                      const std::atomic<bool>* stop = nullptr);
std::optional<CentreParametrizations> centre_parametrizations(
    const Scene& scene, const Intersector& intersector, const RenderSettings& settings,
    const std::atomic<bool>* stop = nullptr);

}  // namespace etalon
