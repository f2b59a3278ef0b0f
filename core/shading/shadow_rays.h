// Shadow rays of many surfaces to one light.
#pragma once

#include <vector>

#include "core/shading/seen_surfaces.h"

namespace etalon {

/// A light's own place is not part of the way to it: what lies within this part of the distance
/// casts no shadow, so that a light may lie on a surface. Well above the roundings of a double.
inline constexpr double shadow_end = 1 - 0x1p-32;

/// Surface that faces a light, whether or not anything is in between: its number, the direction to
/// the light, and the cosine there.
struct FacingSurface {
    std::size_t surface;
    Vec3 towards;
    double cosine;
};

/// The rays from surfaces to one light, of those that scatter and face it: see spawn_ray_to(),
/// whose bits these have.
class ShadowRays {
  public:
    /// `lights`: a point of the light for each surface. A `fixed_bias` other than 0 is how far from
    /// the surface along its normal the rays start.
    ShadowRays(const SeenSurfaces& surfaces, std::span<const Vec3> lights, double fixed_bias);

    std::vector<Ray> rays;
    std::vector<FacingSurface> facing;  ///< the surface of each ray
};

}  // namespace etalon
