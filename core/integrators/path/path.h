// Path tracing (Kajiya 1986) with next-event estimation and multiple importance sampling (Veach
// 1997).
#pragma once

#include <string>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/intersect/batch_intersector.h"
#include "core/light/lights.h"
#include "core/scene/render_settings.h"
#include "core/shading/physical_shading.h"

namespace etalon {

/// Follows the paths of a batch together, vertex by vertex. At each vertex one light is asked for
/// one direction; the same direction as continues the path gives the other estimate of the light.
class PathTracer final : public Integrator {
  public:
    /// Scene and intersector must outlive the integrator. `problems` gets the reasons why images
    /// are replaced by constants.
    PathTracer(const Scene& scene, const BatchIntersector& intersector,
               const RenderSettings& settings, std::vector<std::string>& problems);

    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override;

  private:
    /// How many samples of the light a vertex takes, on average.
    double expected_samples(const Receiver& at, std::uint32_t light) const;

    struct Path;
    struct Vertex;
    class Batch;

    const Scene& scene_;
    const BatchIntersector& intersector_;
    Lights lights_;
    PhysicalShading shading_;
    int most_vertices_;  ///< that scatter
    float roulette_threshold_;
    bool asks_all_;     ///< all lights at each vertex
    bool direct_only_;  ///< no light from surfaces that are not mirrors or glass
};

}  // namespace etalon
