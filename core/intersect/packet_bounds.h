#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/box_columns.h"
#include "core/intersect/ray_packet.h"

namespace etalon {

/// What all rays of a packet lie within: what is outside is no matter for any of them
/// (Boulos, Wald & Shirley 2006, "Geometric and Arithmetic Culling Methods for Entire Ray Packets",
/// University of Utah, UUCS-06-010).
class PacketBounds {
  public:
    /// How much wider the bounds are, in parts of the coordinates' size.
    static constexpr double margin = 0x1p-20;

    /// The bounds of a packet that is not empty. Directions are of usual length: see RescaledRay.
    explicit PacketBounds(const RayPacket& packet);

    /// Whether anything can be said: not of rays that go both ways along the dominant axis.
    bool goes_one_way() const { return goes_up_ || goes_down_; }

    /// Writes to `numbers`, which has room for all, those of the boxes that a ray may meet: none of
    /// the others is within the margin, which is far above all roundings. Returns how many. The
    /// rays go one way.
    std::size_t find_near(const BoxColumns& boxes, std::uint32_t* numbers) const;

    struct Interval {
        double least, most;
    };

    /// What the lines of the rays lie within, axis by axis.
    struct Intervals {
        std::array<Interval, 3> origins;
        /// Against the dominant axis; of that one 1 / its component.
        std::array<Interval, 3> slopes;
    };

  private:
    int dominant_;
    Intervals all_;
    bool goes_up_, goes_down_;  ///< along the dominant axis
};

}  // namespace etalon
