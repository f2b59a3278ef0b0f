#pragma once

#include <array>

#include "core/intersect/batch_intersector.h"
#include "core/light/lights.h"

namespace etalon {

/// Spheres around the beam of a spotlight, in SoA layout. The power of each is that of the light
/// scattered in it.
struct LitSpheres {
    static constexpr std::size_t count = 8;
    std::array<double, count> x{}, y{}, z{};  ///< centres
    std::array<float, count> radius{}, power{};
};

/// A disk about the largest flat patch that a spotlight illuminates. Its power is that of light
/// from a surface with an albedo of a quarter.
struct LitDisk {
    Vec3 centre, normal;  ///< normal: unit, on the side of the light
    double radius2 = 0;
    float power = 0;
};

/// Regions of a medium about the camera that a spotlight illuminates: a disk about the largest flat
/// patch at the end of its beam, and spheres around the beam, each half as large as the one before
/// on the way to the light, where the beam is narrow and bright. Much of the light that is
/// scattered twice comes from there, and few of the directions that a phase function or a BSDF
/// samples hit it.
class LitRegions {
  public:
    /// Makes those of the spotlight of most power; none if no narrow spotlight shines in such a
    /// medium, or if there is also light from the sky.
    LitRegions(const Scene& scene, const Lights& lights, const BatchIntersector& intersector);

    bool empty() const { return part_ == 0; }

    /// Returns the fraction of a vertex's directions that should go to them.
    float part() const { return part_; }

    const LitSpheres& spheres() const { return spheres_; }
    const LitDisk& disk() const { return disk_; }

  private:
    float part_ = 0;
    LitSpheres spheres_;
    LitDisk disk_;
};

}  // namespace etalon
