// Shadow rays of many surfaces to one light.
#pragma once

#include <vector>

#include "core/shading/surface_interaction.h"

namespace etalon {

/// A light's own place is not part of the way to it: what lies within this part of the distance
/// casts no shadow, so that a light may lie on a surface. Well above the roundings of a double.
inline constexpr double shadow_end = 1 - 0x1p-32;

/// Surfaces as a light sees them, side by side, so that several can be looked at at once.
class LitSurfaces {
  public:
    /// Forgets all surfaces and makes room for so many.
    explicit LitSurfaces(std::size_t most);

    void add(const SurfaceInteraction& at);
    std::size_t size() const { return traits_.size(); }

  private:
    friend class ShadowRays;

    struct Traits {
        double front;  ///< 1 where the normal is on the ray's side, else -1
        std::uint32_t primitive;
        Convexity convexity;
    };

    std::vector<Vec3> positions_, errors_, normals_, shading_normals_;  ///< padded, of any value
    std::vector<Traits> traits_;
};

/// Surface that faces a light, whether or not anything is in between: its number, the direction to
/// the light, and the cosine there.
struct FacingSurface {
    std::size_t surface;
    Vec3 towards;
    double cosine;
};

/// The rays from surfaces to one light, of those that face it: see spawn_ray_to(), whose bits these
/// have.
class ShadowRays {
  public:
    /// `lights`: a point of the light for each surface. A `fixed_bias` other than 0 is how far from
    /// the surface along its normal the rays start.
    ShadowRays(const LitSurfaces& surfaces, std::span<const Vec3> lights, double fixed_bias);

    std::vector<Ray> rays;
    std::vector<FacingSurface> facing;  ///< the surface of each ray
};

}  // namespace etalon
