#pragma once

#include <array>

#include "core/intersect/batch_intersector.h"
#include "core/light/lights.h"

namespace etalon {

/// A flat patch that a spot lights up.
struct LitDisk {
    Vec3 centre, normal;  ///< unit, on the side of the spot
    double radius2 = 0;
    float power = 0;
};

/// A disk about the largest flat patch at the end of the beam of a spot, and spheres around the
/// beam in a medium about the camera, each half as large as the one before on the way to the spot,
/// where the beam is narrow and bright. Much of the light that is scattered twice comes from there,
/// and few of the directions that a phase function or a BSDF chooses meet it.
class LitRegions {
  public:
    /// Those of the spot of most power; none where no spot shines in such a medium, or the sky does
    /// beside it.
    LitRegions(const Scene& scene, const Lights& lights, const BatchIntersector& intersector);

    bool empty() const { return part_ == 0; }

    /// The part of a vertex's directions that should go to them.
    float part() const { return part_; }

  private:
    friend class LitRegionsFrom;

    static constexpr std::size_t count = 8;

    float part_ = 0;
    std::array<Vec3, count> centres_{};
    std::array<float, count> radii2_{}, powers_{};
    LitDisk disk_;
};

/// The regions as a point sees them.
class LitRegionsFrom {
  public:
    LitRegionsFrom(const LitRegions& regions, const Receiver& at);

    bool empty() const { return !(sum_ > 0); }
    float part() const { return part_; }

    /// A direction to one of them, for numbers in [0, 1).
    Vec3 sample(double choice, const Vec2& uv) const;

    /// Density of sample() per steradian.
    float density(const Vec3& direction) const;

  private:
    float disk_density(const Vec3& direction) const;
    Vec3 sample_sphere(float wanted, const Vec2& uv) const;

    std::array<float, LitRegions::count> x_, y_, z_;  ///< unit vectors to the centres
    std::array<float, LitRegions::count> sagitta_;    ///< one less the cosine of the sphere's angle
    std::array<float, LitRegions::count> weights_, densities_;
    LitDisk disk_;
    Vec3 to_disk_;
    float disk_weight_ = 0;
    float sum_ = 0, part_;
};

}  // namespace etalon
