#pragma once

#include <span>

#include "core/integrators/ray_counts.h"
#include "core/integrators/whitted/padded_color.h"
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
    /// hit the surfaces. Without `names` the new paths keep their names, as nothing is chosen at
    /// their hits.
    void find(const SeenSurfaces& seen, std::span<const RayPath> seen_by, const WhittedRules& rules,
              bool names, RayCounts& counts);

    std::size_t count = 0;

    /// One entry for each ray; padded with arbitrary values.
    RayBuffer rays;
    PaddedColumn<RayPath> paths;
    PaddedColumn<std::uint32_t> surfaces;  ///< number of the surface that each ray leaves
    PaddedColumn<PaddedColor> weights;     ///< factor of the radiance that each ray brings back
};

}  // namespace etalon
