#pragma once

#include "core/integrators/path/path_scene.h"
#include "core/integrators/ray_counts.h"

namespace etalon {

/// Light that a sample would get from a light if nothing were in between.
struct LightContribution {
    std::uint32_t sample;
    Color color;
};

/// Light contributions and their shadow rays, which are traced together.
class ShadowQueue {
  public:
    /// The media along a shadow ray.
    struct Passage {
        std::uint32_t medium;  ///< medium in which the rest of the ray begins
        RandomSequence numbers;
    };

    void clear();

    void add(const Ray& ray, const LightContribution& light) {
        rays_.push_back(ray);
        rays_.back().set_shadow();
        lights_.push_back(light);
    }

    /// Adds light that media may attenuate: with none, or with all of the queue.
    void add(const Ray& ray, const LightContribution& light, const Passage& passage) {
        add(ray, light);
        passages_.push_back(passage);
    }

    /// Adds the light that arrives to the samples' colours.
    void trace(const PathScene& scene, std::span<Color> colors, RayCounts& counts);

  private:
    void attenuate_all(const PathScene& scene, RayCounts& counts);
    void pass_surfaces(const PathScene& scene, RayCounts& counts);
    void attenuate(const PathScene& scene, std::size_t number, const Ray& ray, double end);
    bool passes(const PathScene& scene, std::size_t number, Ray& ray, const Hit& hit);

    std::vector<Ray> rays_;
    std::vector<LightContribution> lights_;
    std::vector<Passage> passages_;  ///< of each ray; empty without media
    std::vector<std::uint8_t> blocked_;

    // Rays that have passed surfaces without a material.
    std::vector<std::uint32_t> passing_;  ///< their numbers
    std::vector<Ray> passing_rays_;
    std::vector<Hit> passing_hits_;
};

}  // namespace etalon
