// Whitted-style ray tracing (Whitted 1980): point-lit surfaces, mirrors and glass.
#pragma once

#include <string>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/intersect/batch_intersector.h"
#include "core/scene/render_settings.h"
#include "core/shading/environment_map.h"
#include "core/shading/leaving_rays.h"
#include "core/shading/light_samples.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

class Whitted final : public Integrator {
  public:
    /// Scene and intersector must outlive the integrator. `problems`: see EnvironmentMap.
    Whitted(const Scene& scene, const BatchIntersector& intersector, const RenderSettings& settings,
            std::vector<std::string>& problems);

    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override;

    std::vector<std::string> late_problems() const override { return environment_.late_problems(); }

  private:
    /// What belongs to a ray on its way: its sample, its place in the tree of rays, which names the
    /// sample dimensions used at its end, and what the matter around it absorbs.
    struct Path {
        const SampleSource* sample;
        std::uint32_t name;
        Color absorption;
    };

    /// Rays of the same depth (1 for camera rays), followed together, and the path of each.
    struct Rays {
        std::vector<Ray> rays;
        std::vector<Path> paths;
    };

    /// A view of some of them.
    struct RaysView {
        std::span<const Ray> rays;
        std::span<const Path> paths;
    };

    /// The rays that leave the surfaces of a batch for mirrors and glass: each one's surface, and
    /// the weight of its colour there.
    struct SecondaryRays : Rays {
        void reserve(std::size_t count);

        std::vector<std::size_t> surfaces;
        std::vector<Color> weights;
    };

    void trace(const RaysView& batch, int depth, std::span<Color> colors, RayCounts& counts) const;
    SeenSurfaces find_surfaces(const RaysView& batch, std::span<Hit> hits,
                               std::span<Color> colors) const;
    void add_direct(const RaysView& batch, const SeenSurfaces& surfaces, std::span<Color> colors,
                    RayCounts& counts) const;
    std::vector<Vec3> light_points(std::size_t light, int k, const RaysView& batch,
                                   const SeenSurfaces& surfaces) const;
    void add_light(std::size_t light, int k, const RaysView& batch, const SeenSurfaces& surfaces,
                   std::span<Color> reflected, RayCounts& counts) const;
    SecondaryRays secondary_rays(const RaysView& batch, const SeenSurfaces& surfaces,
                                 RayCounts& counts) const;
    void add_secondary(const RaysView& batch, int depth, const SeenSurfaces& surfaces,
                       std::span<Color> colors, RayCounts& counts) const;
    void leave(const RaysView& batch, const SeenSurfaces::Traits& from, const LeavingRays& leaving,
               std::size_t first, std::size_t i, SecondaryRays& to, RayCounts& counts) const;

    const Scene& scene_;
    const BatchIntersector& intersector_;
    EnvironmentMap environment_;
    std::vector<LightSamples> lights_;
    int max_depth_;
    WhittedRules rules_;
};

}  // namespace etalon
