// Bounds of positions and directions of lights, and of what several of them may send to a point.
#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Directions in which lights shine: within `emission` of all normals within `spread` of the axis.
/// Angles in radians, from 0 to pi.
struct EmissionCone {
    Vec3 axis{0, 0, 1};  ///< unit
    double spread = 0;   ///< largest angle of the normals to the axis
    double emission = 0;
    bool two_sided = false;  ///< shines about -axis as well
};

struct LightBounds {
    Box3 box;
    EmissionCone cone;
    double intensity = 0;  ///< luminance sent along the axis, per steradian
};

/// Returns the bounds of the union.
LightBounds united(const LightBounds& a, const LightBounds& b);

/// Bounds of the union of lights that are added one by one, the same as by united(). Most lights of
/// a mesh face within the cone of those before, and need no angles.
class BoundsSum {
  public:
    void add(const LightBounds& light);
    const LightBounds& bounds() const { return sum_; }

  private:
    bool surely_contains(const EmissionCone& cone) const;

    LightBounds sum_;
    double cos_spread_ = 1;
};

/// Returns the cost of a cluster of lights for the choice of clusters: its intensity, times a
/// measure of its directions and one of its size (Conty Estevez & Kulla 2018, section 4.4).
double cluster_cost(const LightBounds& bounds);

}  // namespace etalon
