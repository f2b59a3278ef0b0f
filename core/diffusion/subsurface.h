// Subsurface scattering at a point.
#pragma once

#include <variant>

#include "core/diffusion/normalized_profile.h"
#include "core/diffusion/tabulated_profile.h"

namespace etalon {

/// Distribution of light around the point at which it enters. For a channel and a distance from
/// there: `value` is the power per area; `density` is proportional to it and has the integral 1
/// over a plane; `sample(channel, u)` samples a distance with that density, negative if no light of
/// the channel leaves.
using SpreadProfile = std::variant<TabulatedProfile, NormalizedProfile>;

/// Subsurface scattering at a point of a surface.
struct Subsurface {
    SpreadProfile profile;
    float eta;  ///< index below over index above
};

}  // namespace etalon
