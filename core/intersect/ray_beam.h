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
/// University of Utah, UUCS-06-010).
class RayBeam {
  public:
    /// How far outside, in parts of the coordinates' size, the beam still reaches.
    static constexpr double margin = 0x1p-20;

    /// The beam of a group that is not empty.
    explicit RayBeam(const RayGroup& group);

    /// Whether no ray meets the box or comes near it, within the margin, which is far above all
    /// roundings. False of rays that go different ways, up and down the dominant axis, and where a
    /// calculation leaves the range of doubles.
    bool surely_misses(const Box3& box) const;

  private:
    int dominant_;
    BeamIntervals all_;
    bool goes_up_, goes_down_;  ///< along the dominant axis
};

}  // namespace etalon
