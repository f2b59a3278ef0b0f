// The media of a physical look, and the propagation of rays in them.
#pragma once

#include "core/medium/grid_medium.h"
#include "core/medium/henyey_greenstein.h"
#include "core/medium/ray_segment.h"

namespace etalon {

/// Random numbers for the free flight of a ray.
struct FlightChoices {
    Vec2 first;              ///< in [0, 1)^2
    RandomSequence numbers;  ///< for collisions after the first
};

class Media {
  public:
    /// `media` must outlive it.
    explicit Media(const std::vector<PhysicalMedium>& media);

    /// Samples how far a ray of that throughput goes in a medium before it is scattered.
    FreeFlight sample(std::uint32_t medium, const RaySegment& segment, const Color& throughput,
                      FlightChoices choices) const;

    /// Returns the medium if it has a grid, else null.
    const GridMedium* grid(std::uint32_t medium) const {
        return grids_[medium] ? &*grids_[medium] : nullptr;
    }

    /// Returns the transmittance of a segment of a medium, or an estimate of it.
    Color transmittance(std::uint32_t medium, const RaySegment& segment,
                        RandomSequence& numbers) const;

    /// Returns whether the densities of flights in the medium are known, and there are any.
    bool knows_densities(std::uint32_t medium) const {
        return !grids_[medium] && media_[medium].scattering != Color(0.0F);
    }

    const HenyeyGreenstein& phase(std::uint32_t medium) const { return phases_[medium]; }

  private:
    const std::vector<PhysicalMedium>& media_;
    std::vector<HenyeyGreenstein> phases_;
    std::vector<std::optional<GridMedium>> grids_;  ///< for those that have one
};

}  // namespace etalon
