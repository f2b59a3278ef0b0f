#pragma once

#include <array>

#include "core/intersect/ray_group.h"

namespace etalon {

struct Interval {
    double least, most;
};

/// What the lines of a group of rays lie within, axis by axis.
struct BeamIntervals {
    std::array<Interval, 3> origins;
    std::array<Interval, 3> slopes;  ///< against the dominant axis; of that one 1 / its component
};

/// A group of rays taken together: what is outside of their beam is no matter for any of them
/// (Boulos, Wald & Shirley 2006, "Geometric and Arithmetic Culling Methods for Entire Ray Packets",
/// University of Utah).
class RayBeam {
  public:
    /// The beam of a group that is not empty.
    explicit RayBeam(const RayGroup& group);

    /// Whether no ray meets the box or comes near it: within 2^-20 of the coordinates' size, which
    /// is far above all roundings. False where a calculation leaves the range of doubles.
    bool surely_misses(const Box3& box) const;

  private:
    int dominant_;
    BeamIntervals all_;
};

}  // namespace etalon
