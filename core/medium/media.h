// The media of a physical look: how rays go through them.
#pragma once

#include "core/medium/grid_medium.h"
#include "core/medium/henyey_greenstein.h"
#include "core/medium/ray_segment.h"

namespace etalon {

/// By what a ray's free flight is chosen.
struct FlightChoices {
    Vec2 first;              ///< in [0, 1)^2
    RandomSequence numbers;  ///< of collisions after the first
};

class Media {
  public:
    /// `media` must outlive it.
    explicit Media(const std::vector<PhysicalMedium>& media);

    /// How far a ray of that throughput goes in a medium before it is scattered.
    FreeFlight sample(std::uint32_t medium, const RaySegment& segment, const Color& throughput,
                      FlightChoices choices) const;

    /// The medium if it has a grid, else null.
    const GridMedium* grid(std::uint32_t medium) const {
        return grids_[medium] ? &*grids_[medium] : nullptr;
    }

    /// The part of the light that a segment of a medium lets pass, or an estimate of it.
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
    std::vector<std::optional<GridMedium>> grids_;  ///< of those that have one
};

}  // namespace etalon
