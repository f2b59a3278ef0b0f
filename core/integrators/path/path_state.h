#pragma once

#include <vector>

#include "core/intersect/ray.h"
#include "core/light/receiver.h"
#include "core/sampling/sample_source.h"

namespace etalon {

/// State of a path: the contribution of its camera ray, and the data of the last vertex that are
/// needed to weight the light that the next one finds.
struct PathState {
    std::uint32_t sample;  ///< number in the batch
    std::uint32_t name;    ///< name of its ray, for sample dimensions
    SampleSource source;   ///< source of its random numbers
    Color throughput{1.0F};
    float density = 0;         ///< of the last vertex's rays in this direction, per steradian
    Receiver last{};           ///< the last vertex
    float roulette_scale = 1;  ///< factor of throughput for Russian roulette: the square of the
                               ///< index that it has been divided by, the number of paths among
                               ///< which it was, and how much its directions were favoured
    int depth = 0;             ///< number of scattering vertices
    bool specular = true;      ///< no light could have been sampled for that direction
    bool last_ray = false;     ///< only emission at its end counts
    bool is_unlit = false;     ///< the ray has passed a surface that hides lights from the vertex
    /// One of the paths split at the first vertex with a smooth lobe, or at the first medium with a
    /// grid.
    bool is_split = false;
};

/// Rays that are traced together, and the path to which each belongs.
struct PathWave {
    std::vector<Ray> rays;
    std::vector<PathState> paths;
    std::vector<std::uint32_t> media;  ///< medium of each ray, or no_index; empty without media
    std::vector<Hit> hits;             ///< of the rays, once they are traced

    void clear() {
        rays.clear();
        paths.clear();
        media.clear();
    }
};

}  // namespace etalon
