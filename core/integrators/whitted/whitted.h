// Whitted-style ray tracing (Whitted 1980): point-lit surfaces, mirrors and glass.
#pragma once

#include <string>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/integrators/whitted/ray_tree.h"
#include "core/intersect/batch_intersector.h"
#include "core/parallel/spares.h"
#include "core/scene/render_settings.h"
#include "core/shading/environment_map.h"
#include "core/shading/light_samples.h"

namespace etalon {

class Whitted final : public Integrator {
  public:
    /// Scene and intersector must outlive the integrator. `problems`: see EnvironmentMap.
    Whitted(const Scene& scene, const BatchIntersector& intersector, const RenderSettings& settings,
            std::vector<std::string>& problems);

    void radiance(const CameraSamples& samples, std::span<Color> colors,
                  RayCounts& counts) const override;

    bool uses_sources() const override { return any_random_; }

    std::vector<std::string> late_problems() const override { return environment_.late_problems(); }

  private:
    void trace(RayTree& tree, int depth, const RayBatch& batch, std::span<Color> colors,
               RayCounts& counts) const;
    static void absorb(const RayTree::Level& level, const RayBatch& batch, std::span<Color> colors);
    void find_surfaces(RayTree::Level& level, const RayBatch& batch, std::span<Color> colors) const;
    void set_direct(RayTree::Level& level, const RayBatch& batch, RayCounts& counts) const;
    static void combine_direct(RayTree::Level& level);
    void name_vertices(RayTree::Level& level, const RayBatch& batch) const;
    void find_light_points(std::size_t light, int k, RayTree::Level& level) const;
    template <class Add>
    void reflect_light(RayTree::Level& level, const Add& add) const;
    template <class Add>
    void add_light(std::size_t light, int k, RayTree::Level& level, const RayBatch& batch,
                   RayCounts& counts, const Add& add) const;
    void add_secondary(RayTree& tree, int depth, const RayBatch& batch, RayCounts& counts) const;

    const Scene& scene_;
    const BatchIntersector& intersector_;
    EnvironmentMap environment_;
    std::vector<LightSamples> lights_;
    bool any_random_ = false;  ///< points on some light are chosen at random
    bool any_absorbs_;         ///< some material absorbs light behind its surface
    int max_depth_;
    Sampler sampler_;
    WhittedRules rules_;
    mutable Spares<RayTree> trees_;
};

}  // namespace etalon
