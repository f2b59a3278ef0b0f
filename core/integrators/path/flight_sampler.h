#pragma once

#include "core/integrators/path/shadow_queue.h"
#include "core/medium/grid_medium.h"
#include "core/medium/ray_segment.h"
#include "core/sampling/vertex_points.h"

namespace etalon {

/// Samples how far rays go in their media before they are scattered. The scene must outlive it.
class FlightSampler {
  public:
    explicit FlightSampler(const PathScene& scene) : scene_(scene) {}

    /// Samples the flights of all rays of a wave, and attenuates the paths that pass their media.
    /// Paths that are scattered at several points of a grid are added to the wave, and light of
    /// point lights sampled along the rays to `shadows`.
    void sample(PathWave& wave, ShadowQueue& shadows);

    /// Returns the parameter of the ray at which its medium scatters it, else infinity.
    double distance(std::size_t ray) const { return distances_[ray]; }

    /// Returns the density of that distance, per unit of length, if a light was sampled along the
    /// ray beside, else 0.
    float density(std::size_t ray) const { return densities_[ray]; }

  private:
    /// Returns whether a medium may scatter a ray.
    bool flies(const PathWave& wave, std::size_t ray) const {
        return wave.media[ray] != no_index && scene_.may_go_on(wave.paths[ray]);
    }

    /// Returns the grid in which such a ray's path is split, or null.
    const GridMedium* grid_to_divide(const PathWave& wave, std::size_t ray) const {
        if (scene_.split_count(wave.paths[ray]) == 1) return nullptr;
        return scene_.media.grid(wave.media[ray]);
    }

    void make_points(const PathWave& wave);
    void sample(PathWave& wave, std::size_t ray, std::size_t number, ShadowQueue& shadows);
    void divide(PathWave& wave, std::size_t ray, const GridMedium& grid, std::size_t number);
    void add_scattered(PathWave& wave, std::size_t ray, const PathState& path,
                       const FreeFlight& flight);

    const PathScene& scene_;
    std::vector<double> distances_;
    std::vector<float> densities_;
    VertexPoints points_{Decision::flight};
    DensityProfile profile_;
};

}  // namespace etalon
