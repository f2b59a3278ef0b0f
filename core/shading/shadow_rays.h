// Shadow rays of many surfaces to one light.
#pragma once

#include <cstdint>

#include "core/shading/seen_surfaces.h"

namespace etalon {

/// A light's own place is not part of the way to it: what lies within this part of the distance
/// casts no shadow, so that a light may lie on a surface. Well above the roundings of a double.
inline constexpr double shadow_end = 1 - 0x1p-32;

/// The rays from surfaces to one light, of those that scatter and face it, whether or not anything
/// is in between: see spawn_ray_to(), whose bits these have. To be aimed again and again.
class ShadowRays {
  public:
    /// `lights`: a point of the light for each surface. A `fixed_bias` other than 0 is how far from
    /// the surface along its normal the rays start.
    void aim(const SeenSurfaces& surfaces, const Vec3Buffer& lights, double fixed_bias);

    std::size_t size() const { return count_; }

    /// Number of the surface that ray number i leaves; ascending.
    std::size_t surface(std::size_t i) const { return static_cast<std::size_t>(surfaces[i]); }

    RayStream rays() const {
        RayStream stream = rays_.view(count_);
        stream.tmax = shadow_end;
        return stream;
    }

    /// Of each ray; padded, of any value there.
    PaddedColumn<std::int64_t> surfaces;  ///< number of the surface
    Vec3Buffer towards;                   ///< unit vector to the light
    PaddedColumn<double> cosines;         ///< product of it with the shading normal

  private:
    RayBuffer rays_;
    std::size_t count_ = 0;
};

}  // namespace etalon
