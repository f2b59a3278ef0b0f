#pragma once

#include "core/medium/density_profile.h"
#include "core/medium/grid_cell.h"
#include "core/sampling/random_sequence.h"

namespace etalon {

/// A medium whose density is that of a grid, sampled without bias.
class GridMedium {
  public:
    /// `medium` must have a grid and outlive this.
    explicit GridMedium(const PhysicalMedium& medium);

    /// Returns the density at a point of the grid's box.
    float density(const Vec3& point) const { return density_at(grid_, point); }

    /// Returns the fraction of extinguished light that is scattered.
    const Color& albedo() const { return albedo_; }

    /// Samples how far a ray goes, by null collisions with the largest density near the ray
    /// (Woodcock et al. 1965). Each collision is real or null by all channels of the throughput
    /// together (spectral tracking: Kutz et al. 2017, section 4). `first` in [0, 1) is for the
    /// first collision.
    FreeFlight sample(const RaySegment& segment, const Color& throughput, double first,
                      RandomSequence& numbers) const;

    /// Computes how much of a ray's light passes, exactly up to roundings, and fills the profile.
    DividedLight divide(const RaySegment& segment, DensityProfile& profile) const;

    /// Samples where light that does not pass is scattered: in proportion to the channels of the
    /// throughput, by `choices` in [0, 1)^2 for the distance and the channel.
    FreeFlight sample(const DensityProfile& profile, const Color& throughput,
                      const Vec2& choices) const;

    /// Estimates the transmittance of the segment: that of the least density near the ray exactly,
    /// and that of the rest by ratio tracking (Novak et al. 2014).
    Color transmittance(const RaySegment& segment, RandomSequence& numbers) const;

  private:
    RaySegment in_box(const RaySegment& segment) const;
    FreeFlight sample_rest(const RaySegment& segment, const Color& throughput,
                           RandomSequence& numbers) const;
    Color removed(const DensityProfile& profile) const;

    const PhysicalMedium& medium_;
    const DensityGrid& grid_;
    DensityBounds bounds_;
    Color extinction_;
    float largest_;   ///< largest channel of the extinction
    Color relative_;  ///< extinction over its largest channel
    Color albedo_;
};

}  // namespace etalon
