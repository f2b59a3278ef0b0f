// Features of an image beside its light: for denoisers, compositors, and reports on what an
// accelerator did. Rendered by rays of their own, which nothing else counts.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "core/intersect/intersector.h"
#include "core/render/film.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

/// Means over the first samples of each pixel, at most 16: the image's own, so that what is
/// behind an edge has the same share. A miss counts as 0.
struct SurfaceMeans {
    Film albedo;  ///< diffuse + reflection + transmission of the material, each in [0, 1]
    Film normal;  ///< shading normal, unit, on the side of the surface that is seen
};

/// Hits of one ray through the centre of each pixel and of the lens, by rows from the top.
struct CentreHits {
    std::vector<Vec3f> positions;           ///< 0 for a miss
    std::vector<float> depths;              ///< along the camera's axis; infinity for a miss
    std::vector<std::uint32_t> primitives;  ///< as in a Hit, or no_index
    std::vector<std::uint32_t> instances;   ///< as in a Hit
    std::vector<TraversalCost> costs;       ///< costs as far as the backend counts
};

/// Surface coordinates where those rays end, with their derivatives in the world; 0 for a miss.
struct CentreParametrizations {
    std::vector<Imath::V2f> uv;
    std::vector<Vec3f> dpdu, dpdv;
};

/// Renders the features of an image of these settings; nothing if `stop` was set meanwhile. All are
/// the same for any number of threads.
std::optional<SurfaceMeans> surface_means(const Scene& scene, const Intersector& intersector,
                                          const RenderSettings& settings,
                                          const std::atomic<bool>* stop = nullptr);
std::optional<CentreHits> centre_hits(const Scene& scene, const Intersector& intersector,
                                      const RenderSettings& settings,
                                      const std::atomic<bool>* stop = nullptr);
std::optional<CentreParametrizations> centre_parametrizations(
    const Scene& scene, const Intersector& intersector, const RenderSettings& settings,
    const std::atomic<bool>* stop = nullptr);

}  // namespace etalon
