#pragma once

#include "core/medium/ray_segment.h"
#include "core/scene/physical_medium.h"

namespace etalon {

/// Samples how far a ray goes in a homogeneous medium: by the extinction of one channel, chosen in
/// proportion to the throughput, and weighted by the density of all channels together. `choices` in
/// [0, 1)^2 are for the distance and the channel.
FreeFlight sample_homogeneous(const PhysicalMedium& medium, const RaySegment& segment,
                              const Color& throughput, const Vec2& choices);

/// Returns the density per unit of length with which sample_homogeneous() samples that distance in
/// a longer segment of a scattering medium.
float flight_density(const PhysicalMedium& medium, const Color& throughput, double distance);

}  // namespace etalon
