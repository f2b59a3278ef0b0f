#pragma once

#include "core/medium/ray_segment.h"
#include "core/scene/physical_medium.h"

namespace etalon {

/// Chooses how far a ray goes in a medium that is the same everywhere: by the extinction of one
/// channel, chosen as the channels of the throughput are, and weighted by the density that all
/// channels together have there. `choices` in [0, 1)^2: the distance and the channel.
FreeFlight sample_homogeneous(const PhysicalMedium& medium, const RaySegment& segment,
                              const Color& throughput, const Vec2& choices);

/// Density per unit of length with which sample_homogeneous() chooses that distance in a segment
/// that is longer, in a medium that scatters.
float flight_density(const PhysicalMedium& medium, const Color& throughput, double distance);

}  // namespace etalon
