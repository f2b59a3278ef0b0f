#pragma once

#include <span>
#include <vector>

#include "core/integrators/ray_counts.h"
#include "core/scene/render_settings.h"
#include "core/shading/seen_surfaces.h"

namespace etalon {

/// The state of a path at a ray: its sample, its position in the tree of rays, from which the
/// sample dimensions at its hit are derived, and the absorption of the medium around it.
struct RayPath {
    std::uint32_t sample;  ///< number of its camera ray
    std::uint32_t name;
    Color absorption;
};

/// The rays that mirrors and glass send on from the surfaces of a batch. Reused from batch to
/// batch.
struct SecondaryRays {
    /// Finds the rays and adds their number to `counts`. `seen_by` holds the paths of the rays that
    /// hit the surfaces.
    void find(const SeenSurfaces& seen, std::span<const RayPath> seen_by, const WhittedRules& rules,
              RayCounts& counts);

    RayBuffer rays;
    std::vector<RayPath> paths;
    std::vector<std::uint32_t> surfaces;  ///< number of the surface that each ray leaves
    std::vector<Color> weights;           ///< factor of the radiance that each ray brings back
};

}  // namespace etalon
