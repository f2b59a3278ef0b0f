#include "core/integrators/ao/ambient_occlusion.h"

#include <numeric>

#include "core/sampling/dimensions.h"
#include "core/sampling/hemisphere.h"
#include "core/shading/surface_interaction.h"

namespace etalon {
namespace {

/// Number of occlusion rays of a pixel with a single camera ray. Otherwise each sample has one
/// occlusion ray, so that --spp alone determines the noise and the time.
constexpr std::uint32_t rays_without_samples = 64;

}  // namespace

AmbientOcclusion::AmbientOcclusion(const Scene& scene, const BatchIntersector& intersector,
                                   const RenderSettings& settings, std::vector<std::string>&)
    : scene_(scene),
      intersector_(intersector),
      max_distance_(settings.max_distance),
      rays_(settings.samples_per_pixel > 0 ? 1 : rays_without_samples) {}

void AmbientOcclusion::radiance(const CameraSamples& samples, std::span<Color> colors,
                                RayCounts& counts) const {
    std::vector<Hit> hits(samples.rays.size());
    intersector_.closest(samples.rays, hits);
    counts.camera += hits.size();

    std::vector<Ray> rays;
    std::vector<std::size_t> open;  // the camera rays that hit
    for (std::size_t i = 0; i < hits.size(); ++i) {
        colors[i] = Color(0.0F);
        if (hits[i].primitive == no_index) continue;
        open.push_back(i);
        append_occlusion_rays(samples.rays[i], samples.sources[i], hits[i], rays);
    }
    std::vector<std::uint8_t> blocked(rays.size());
    intersector_.occluded(rays, blocked);
    counts.camera_hits += open.size();
    counts.shadow += rays.size();

    const auto all = static_cast<float>(rays_);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto first = blocked.begin() + static_cast<std::ptrdiff_t>(i * rays_);
        const std::uint32_t count = std::accumulate(first, first + rays_, 0U);
        counts.shadow_blocked += count;
        colors[open[i]] = Color(static_cast<float>(rays_ - count) / all);
    }
}

/// Appends rays from the hit of a camera ray into its hemisphere.
void AmbientOcclusion::append_occlusion_rays(const Ray& ray, const SampleSource& sample,
                                             const Hit& hit, std::vector<Ray>& to) const {
    const SurfaceInteraction at = surface_interaction(scene_, ray, hit);
    const std::uint32_t dimension = occlusion_dimension(camera_ray_name);
    for (std::uint32_t k = 0; k < rays_; ++k) {
        const Vec2 uv = sample.stratified(dimension, k, rays_);
        to.push_back(spawn_ray(at.surface, cosine_direction(at.ng, uv)));
        to.back().tmax = max_distance_;
    }
}

}  // namespace etalon
