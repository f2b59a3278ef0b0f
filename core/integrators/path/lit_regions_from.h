#pragma once

#include "core/integrators/path/lit_spheres_from.h"

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
    void see(const LitDisk& disk, const Receiver& at);
    Vec3 sample_disk(const Vec2& uv) const;
    Vec3 sample_sphere(float wanted, const Vec2& uv) const;
    float disk_density(const Vec3& direction) const;

    LitSpheresFrom spheres_;
    const LitDisk& disk_;
    Vec3 to_disk_;
    float disk_weight_ = 0;
    float sum_ = 0;  ///< sum of all weights
    float part_;
};

}  // namespace etalon
