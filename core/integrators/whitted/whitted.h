// Whitted-style ray tracing (Whitted 1980): point-lit surfaces, mirrors and glass.
#pragma once

#include <string>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/intersect/intersector.h"
#include "core/scene/render_settings.h"
#include "core/shading/environment_map.h"
#include "core/shading/light_samples.h"
#include "core/shading/surface_interaction.h"

namespace etalon {

class Whitted final : public Integrator {
  public:
    /// Scene and intersector must outlive the integrator. `problems`: see EnvironmentMap.
    Whitted(const Scene& scene, const Intersector& intersector, const RenderSettings& settings,
            std::vector<std::string>& problems);

    Color radiance(const Ray& camera_ray, const SampleSource& sample,
                   RayCounts& counts) const override;

  private:
    /// A ray on its way: its depth (1 for the camera ray), its place in the tree of rays, which
    /// names the sample dimensions used at its end, and what the matter around it absorbs.
    struct Path {
        Ray ray;
        int depth;
        std::uint32_t name;
        Color absorption;
    };

    struct Context {
        const SampleSource& sample;
        RayCounts& counts;
    };

    Color trace(const Path& path, std::optional<Hit> hit, Context& context) const;
    Color direct(const Path& path, const SurfaceInteraction& at, Context& context) const;
    Color lit_by(const Vec3& light, const Path& path, const SurfaceInteraction& at,
                 Context& context) const;
    Color secondary(const Path& path, const SurfaceInteraction& at, Context& context) const;
    Ray leave(const SurfaceInteraction& at, const Vec3& direction, bool crosses) const;
    Color follow(const Path& from, const SurfaceInteraction& at, const Vec3& direction, bool inside,
                 Context& context) const;

    const Scene& scene_;
    const Intersector& intersector_;
    EnvironmentMap environment_;
    std::vector<LightSamples> lights_;
    int max_depth_;
    WhittedRules rules_;
};

}  // namespace etalon
