// Where lights are and where they shine: bounds for what may reach a point from several of them.
#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Directions in which lights shine: `emission` about all that are within `spread` of the axis.
/// Angles in radians, from 0 to pi.
struct EmissionCone {
    Vec3 axis{0, 0, 1};  ///< unit
    double spread = 0;   ///< of the normals
    double emission = 0;
    bool two_sided = false;  ///< shines about -axis as well
};

struct LightBounds {
    Box3 box;
    EmissionCone cone;
    double intensity = 0;  ///< luminance of what is sent along the axis, per steradian
};

/// The bounds of what both of two bound.
LightBounds united(const LightBounds& a, const LightBounds& b);

/// What a cluster of lights costs those who choose among clusters: its intensity, times a measure
/// of its directions and one of its size (Conty Estevez & Kulla 2018, section 4.4).
double cluster_cost(const LightBounds& bounds);

}  // namespace etalon
