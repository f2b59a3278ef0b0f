// Shadow rays of many surfaces to one light.
#pragma once

#include <cstdint>

#include "core/shading/seen_surfaces.h"

namespace etalon {

/// tmax of shadow rays, which reach the light at t = 1. It leaves out the last 2^-32 of the
/// distance, so that a surface on which the light lies casts no shadow. That is well above the
/// rounding errors of a double.
inline constexpr double shadow_end = 1 - 0x1p-32;

/// The point of a light to which each surface has a ray: one for all of them, or for each.
struct LightPoints {
    bool is_one = false;
    Vec3 one{0};
    Vec3Buffer each;
};

/// The rays to one light from those surfaces that scatter and face it. They have the bits of
/// spawn_ray_to(). Reused from batch to batch.
class ShadowRays {
  public:
    /// Computes the rays. A `fixed_bias` other than 0 is the distance of the origins from the
    /// surface along its normal.
    void aim(const SeenSurfaces& surfaces, const LightPoints& lights, double fixed_bias);

    std::size_t size() const { return count_; }

    /// Returns the number of the surface that ray number i leaves. It grows with i.
    std::size_t surface(std::size_t i) const { return static_cast<std::size_t>(surfaces[i]); }

    /// Returns the number of the first ray that leaves that surface or a later one.
    std::size_t first_from(std::size_t surface) const;

    RayStream rays() const {
        RayStream stream = rays_.view(count_);
        stream.tmax = shadow_end;
        return stream;
    }

    /// One entry for each ray; padded with arbitrary values.
    PaddedColumn<std::int64_t> surfaces;  ///< number of the surface
    Vec3Buffer towards;                   ///< unit vector to the light
    PaddedColumn<double> cosines;         ///< its dot product with the shading normal
    std::vector<std::uint8_t> blocked;  ///< 1 if occluded: 0 until whoever traces the rays sets it

  private:
    RayBuffer rays_;
    std::size_t count_ = 0;
};

}  // namespace etalon
