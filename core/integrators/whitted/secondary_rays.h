#pragma once

#include <span>
#include <vector>

#include "core/integrators/ray_counts.h"
#include "core/scene/render_settings.h"
#include "core/shading/seen_surfaces.h"

namespace etalon {

/// What belongs to a ray on its way: its sample, its place in the tree of rays, which names the
/// sample dimensions used at its end, and what the matter around it absorbs.
struct RayPath {
    std::uint32_t sample;  ///< its number among those of the camera rays
    std::uint32_t name;
    Color absorption;
};

/// The rays that leave the surfaces of a batch for mirrors and glass. To be found again and again.
struct SecondaryRays {
    /// `paths` are those of the rays that have seen the surfaces. Counts the rays.
    void find(const SeenSurfaces& seen, std::span<const RayPath> seen_by, const WhittedRules& rules,
              RayCounts& counts);

    RayBuffer rays;
    std::vector<RayPath> paths;
    std::vector<std::uint32_t> surfaces;  ///< where each begins
    std::vector<Color> weights;           ///< of its colour there
};

}  // namespace etalon
