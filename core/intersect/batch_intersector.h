#pragma once

#include <cstdint>
#include <span>

#include "core/intersect/ray_stream.h"

namespace etalon {

/// Finds the hits of many rays in one call: the interface that integrators see. Thread-safe.
class BatchIntersector {
  public:
    BatchIntersector() = default;
    virtual ~BatchIntersector() = default;
    BatchIntersector(const BatchIntersector&) = delete;
    BatchIntersector& operator=(const BatchIntersector&) = delete;

    /// Sets `hits`, one for each ray, to the nearest hit with tmin < t <= tmax; at equal t that of
    /// the lower key. A miss has no_index for a primitive.
    virtual void closest(std::span<const Ray> rays, std::span<Hit> hits) const = 0;

    /// Sets `blocked`, one for each ray, to 1 where closest() finds a hit, else 0.
    virtual void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const = 0;

    /// The same queries for rays in SoA layout. By default they are converted to single rays first.
    virtual void closest(const RayStream& rays, std::span<Hit> hits) const;
    virtual void occluded(const RayStream& rays, std::span<std::uint8_t> blocked) const;
};

}  // namespace etalon
