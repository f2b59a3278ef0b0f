#include "core/integrators/ao/ambient_occlusion.h"

#include "core/sampling/dimensions.h"
#include "core/sampling/hemisphere.h"
#include "core/shading/surface_interaction.h"

namespace etalon {
namespace {

/// Number of occlusion rays of a pixel that has one camera ray only. Where pixels have samples each
/// has one occlusion ray, so that --spp alone decides the noise and the time.
constexpr std::uint32_t rays_without_samples = 64;

}  // namespace

AmbientOcclusion::AmbientOcclusion(const Scene& scene, const Intersector& intersector,
                                   const RenderSettings& settings, std::vector<std::string>&)
    : scene_(scene),
      intersector_(intersector),
      max_distance_(settings.max_distance),
      rays_(settings.samples_per_pixel > 0 ? 1 : rays_without_samples) {}

Color AmbientOcclusion::radiance(const Ray& camera_ray, const SampleSource& sample,
                                 RayCounts& counts) const {
    ++counts.camera;
    const std::optional<Hit> hit = intersector_.closest(camera_ray);
    if (!hit) return Color(0.0F);
    ++counts.camera_hits;
    const SurfaceInteraction at = surface_interaction(scene_, camera_ray, *hit);
    const std::uint32_t dimension = occlusion_dimension(camera_ray_name);
    std::uint32_t blocked = 0;
    for (std::uint32_t k = 0; k < rays_; ++k) {
        const Vec2 uv = sample.stratified(dimension, k, rays_);
        Ray ray = spawn_ray(at.surface, cosine_direction(at.ng, uv));
        ray.tmax = max_distance_;
        if (intersector_.occluded(ray)) ++blocked;
    }
    counts.shadow += rays_;
    counts.shadow_blocked += blocked;
    return Color(static_cast<float>(rays_ - blocked) / static_cast<float>(rays_));
}

}  // namespace etalon
