#pragma once

#include <string>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/intersect/batch_intersector.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

/// Ambient occlusion (Zhukov, Iones & Kronin 1998): the cosine-weighted fraction of the hemisphere
/// above a surface that is open, between 0 and 1. The hemisphere is that of the geometric normal on
/// the camera's side; materials and lights are ignored. A camera ray that misses is black, as in
/// pbrt-v3, whose values are pi times these.
class AmbientOcclusion final : public Integrator {
  public:
    /// Scene and intersector must outlive the integrator.
    AmbientOcclusion(const Scene& scene, const BatchIntersector& intersector,
                     const RenderSettings& settings, std::vector<std::string>& problems);

    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override;

  private:
    void append_occlusion_rays(const Ray& ray, const SampleSource& sample, const Hit& hit,
                               std::vector<Ray>& to) const;

    const Scene& scene_;
    const BatchIntersector& intersector_;
    double max_distance_;
    std::uint32_t rays_;  ///< number of rays for each camera ray
};

}  // namespace etalon
