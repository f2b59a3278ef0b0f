#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/camera.h"

namespace etalon {

/// A ray in the space of a lens: the axis is z, the film is at z = 0, the scene at large z.
struct LensRay {
    Vec3 origin;
    Vec3 direction;  ///< a unit vector once a surface has refracted it
};

/// Traces rays through the surfaces of a lens (Kolb et al. 1995, section 3.1).
class LensTracer {
  public:
    explicit LensTracer(std::span<const LensSurface> surfaces);

    /// Returns the ray that leaves the lens towards the scene; nothing if a rim or a stop blocks
    /// the ray, or a surface reflects it totally.
    std::optional<LensRay> from_film(LensRay ray) const;

    /// The same in the other direction.
    std::optional<LensRay> from_scene(LensRay ray) const;

    double front_z() const { return surfaces_.front().z; }
    double rear_z() const { return surfaces_.back().z; }
    double rear_radius() const { return rear_radius_; }

  private:
    struct Surface {
        double z;  ///< position on the axis
        double curvature_radius;
        double aperture2;
        double eta_front, eta_rear;  ///< on the sides of the scene and of the film
    };

    static bool pass(const Surface& surface, bool to_scene, LensRay& ray);

    std::vector<Surface> surfaces_;  ///< from the scene to the film
    double rear_radius_;
};

}  // namespace etalon
