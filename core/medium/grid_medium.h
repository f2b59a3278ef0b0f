#pragma once

#include "core/medium/density_profile.h"
#include "core/medium/grid_cell.h"
#include "core/sampling/random_sequence.h"

namespace etalon {

/// A medium whose density is that of a grid, followed without bias.
class GridMedium {
  public:
    /// `medium`, one with a grid, must outlive it.
    explicit GridMedium(const PhysicalMedium& medium);

    /// Density at a point of the grid's box.
    float density(const Vec3& point) const { return density_at(grid_, point); }

    /// The part of removed light that is scattered.
    const Color& albedo() const { return albedo_; }

    /// Chooses how far a ray goes: by null collisions with the largest density near the ray
    /// (Woodcock et al. 1965), each real or null by what the channels of the throughput have there
    /// on the whole (spectral tracking: Kutz et al. 2017, section 4). The first collision is at
    /// `first` in [0, 1).
    FreeFlight sample(const RaySegment& segment, const Color& throughput, double first,
                      RandomSequence& numbers) const;

    /// Finds what of a ray's light passes, exactly but for roundings, and fills the profile.
    DividedLight divide(const RaySegment& segment, DensityProfile& profile) const;

    /// Chooses where light that does not pass is scattered: in proportion to the channels of the
    /// throughput, by `choices` in [0, 1)^2 of the distance and the channel.
    FreeFlight sample(const DensityProfile& profile, const Color& throughput,
                      const Vec2& choices) const;

    /// Estimates the part of the light that is left at the segment's end: that of the least density
    /// near the ray exactly, and that of the rest by ratio tracking (Novak et al. 2014).
    Color transmittance(const RaySegment& segment, RandomSequence& numbers) const;

  private:
    RaySegment in_box(const RaySegment& segment) const;
    Color removed(const DensityProfile& profile) const;

    const PhysicalMedium& medium_;
    const DensityGrid& grid_;
    DensityBounds bounds_;
    Color extinction_;
    float largest_;   ///< of the extinction's channels
    Color relative_;  ///< extinction over its largest channel
    Color albedo_;
};

}  // namespace etalon
