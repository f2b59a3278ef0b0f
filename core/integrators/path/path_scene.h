#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/integrators/path/lit_regions.h"
#include "core/integrators/path/path_state.h"
#include "core/medium/media.h"
#include "core/scene/render_settings.h"
#include "core/shading/physical_shading.h"

namespace etalon {

/// Data that all paths of an image share. Scene and intersector must outlive it.
struct PathScene {
    /// `problems` gets the reasons why images are replaced by constants. `in_media`: rays are
    /// attenuated and scattered by media.
    PathScene(const Scene& of, const BatchIntersector& by, const RenderSettings& settings,
              std::vector<std::string>& problems, bool in_media)
        : scene(of),
          intersector(by),
          lights(of, problems, in_media ? SkySampling::whole : SkySampling::above_mean),
          media(of.physical().media),
          shading(of, problems),
          most_vertices(settings.max_depth - 1),
          roulette_threshold(
              std::max(std::numeric_limits<float>::min(), settings.roulette_threshold)),
          samples_all(settings.sample_all_lights),
          direct_only(settings.direct_lighting),
          sampler(settings.sampler) {
        if (in_media) lit_regions.emplace(of, lights, by);
        if (lit_regions && lit_regions->empty()) lit_regions.reset();
    }

    /// Returns how many samples of the light a vertex takes, on average.
    double expected_samples(const Receiver& at, std::uint32_t light) const {
        return samples_all ? lights.samples(light) : lights.pick_probability(at, light);
    }

    /// Returns whether a path may be scattered at its next vertex.
    bool may_go_on(const PathState& path) const {
        return !path.last_ray && path.depth < most_vertices;
    }

    /// Number of paths into which a path is split at its first vertex with a smooth lobe. They
    /// share the camera ray and the light sampled there, which are less noisy than what follows.
    static constexpr std::uint32_t split_factor = 2;

    /// Returns the number of paths into which a path is split at a smooth lobe.
    std::uint32_t split_count(const PathState& path) const {
        return path.is_split || samples_all ? 1 : split_factor;
    }

    const Scene& scene;
    const BatchIntersector& intersector;
    Lights lights;
    Media media;
    PhysicalShading shading;
    std::optional<LitRegions> lit_regions;  ///< if there are any
    int most_vertices;                      ///< largest number of scattering vertices
    float roulette_threshold;  ///< above 0: a threshold of 0 and less is that of no roulette
    bool samples_all;          ///< sample all lights at each vertex
    bool direct_only;          ///< no indirect light, except in mirrors and glass
    Sampler sampler;
};

}  // namespace etalon
