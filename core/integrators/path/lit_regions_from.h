#pragma once

#include "core/integrators/path/lit_regions.h"

namespace etalon {

/// The regions as seen from a point, to which directions are sampled. The regions must outlive it.
class LitRegionsFrom {
  public:
    LitRegionsFrom(const LitRegions& regions, const Receiver& at);

    bool empty() const { return !(sum_ > 0); }
    float part() const { return part_; }

    /// Samples a direction to one of them, with numbers in [0, 1).
    Vec3 sample(double choice, const Vec2& uv) const;

    /// Returns the density of sample() per steradian.
    float density(const Vec3& direction) const;

  private:
    void see_spheres(const LitSpheres& spheres, const Receiver& at);
    void see(const LitDisk& disk, const Receiver& at);
    Vec3 sample_disk(const Vec2& uv) const;
    Vec3 sample_sphere(float wanted, const Vec2& uv) const;
    float disk_density(const Vec3& direction) const;

    // The spheres in SoA layout. A cone is given by 1 - cos of its half angle, which is half the
    // largest squared distance between the ends of its unit vectors and of its axis.
    std::array<float, LitSpheres::count> x_, y_, z_;  ///< axes
    std::array<float, LitSpheres::count> sagitta_;    ///< 1 - cos; 2 for all directions
    std::array<float, LitSpheres::count> weights_, densities_;

    const LitDisk& disk_;
    Vec3 to_disk_;
    float disk_weight_ = 0;
    float sum_ = 0;  ///< sum of all weights
    float part_;
};

}  // namespace etalon
