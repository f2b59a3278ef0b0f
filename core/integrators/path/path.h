// Path tracing (Kajiya 1986) with next-event estimation and multiple importance sampling (Veach
// 1997).
#pragma once

#include "core/integrators/integrator.h"
#include "core/integrators/path/path_scene.h"

namespace etalon {

/// Follows the paths of a batch together, vertex by vertex. At each vertex one light is sampled for
/// one direction; the direction in which the path continues gives the other estimate of the light.
class PathTracer final : public Integrator {
  public:
    /// Scene and intersector must outlive the integrator. `problems` gets the reasons why images
    /// are replaced by constants.
    PathTracer(const Scene& scene, const BatchIntersector& intersector,
               const RenderSettings& settings, std::vector<std::string>& problems)
        : scene_(scene, intersector, settings, problems, false) {}

    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override;

    bool shows_lights() const override { return scene_.lights.can_be_seen(); }
    void emission(const CameraSamples& samples, std::span<Color> colors) const override;
    const PhysicalShading* shading() const override { return &scene_.shading; }

  private:
    PathScene scene_;
};

/// The same for scenes with media. Surfaces without a material do not block light.
class VolumePathTracer final : public Integrator {
  public:
    /// See PathTracer.
    VolumePathTracer(const Scene& scene, const BatchIntersector& intersector,
                     const RenderSettings& settings, std::vector<std::string>& problems);

    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override;

    /// False in media, through which the outline of a light is not worth additional samples.
    bool shows_lights() const override { return !in_media_ && scene_.lights.can_be_seen(); }
    void emission(const CameraSamples& samples, std::span<Color> colors) const override;
    const PhysicalShading* shading() const override { return &scene_.shading; }

  private:
    bool in_media_;  ///< the scene has something that PathTracer does not render
    PathScene scene_;
};

}  // namespace etalon
