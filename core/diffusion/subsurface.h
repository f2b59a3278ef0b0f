// What scatters light below a surface, so that it comes out elsewhere.
#pragma once

#include <variant>

#include "core/diffusion/normalized_profile.h"
#include "core/diffusion/tabulated_profile.h"

namespace etalon {

/// How light spreads around the point at which it enters; of a channel and a distance from there:
/// `value`, power per area; `density`, that is proportional to it and has the integral 1 over a
/// plane; `sample(channel, u)`, a distance chosen with it, below 0 where the channel lets nothing
/// out.
using SpreadProfile = std::variant<TabulatedProfile, NormalizedProfile>;

/// At a point of a surface.
struct Subsurface {
    SpreadProfile profile;
    float eta;  ///< index below over index above
};

}  // namespace etalon
