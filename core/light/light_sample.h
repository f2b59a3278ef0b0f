#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Unoccluded light that may reach a point from one direction.
struct LightSample {
    Vec3 wi{0.0};              ///< unit vector to the light
    Vec3 target{0.0};          ///< end of the shadow ray, unless at infinity
    bool at_infinity = false;  ///< the shadow ray has no end
    Color radiance{0.0F};      ///< for a light without extent, to be used with a density of 1
    float pdf = 0;             ///< per steradian; 0: no light from there
    bool is_delta = false;     ///< no direction sampled otherwise can hit the light
};

}  // namespace etalon
