#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Light that may reach a point from one direction, before anything stands in its way.
struct LightSample {
    Vec3 wi{0.0};              ///< unit vector to the light
    Vec3 target{0.0};          ///< where the way to the light ends, unless at infinity
    bool at_infinity = false;  ///< the way to the light has no end
    Color radiance{0.0F};      ///< for a light without extent what a density of 1 makes of it
    float pdf = 0;             ///< per steradian; 0: no light from there
    bool is_delta = false;     ///< no direction sampled otherwise can meet the light
};

}  // namespace etalon
