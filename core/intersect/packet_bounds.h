#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/box_columns.h"
#include "core/intersect/ray_packet.h"

namespace etalon {

/// Bounds of all rays of a packet: no ray can hit anything outside them (Boulos, Wald & Shirley
/// 2006, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of Utah,
/// UUCS-06-010).
class PacketBounds {
  public:
    /// Relative margin by which the bounds are enlarged, as a fraction of the coordinates'
    /// magnitude.
    static constexpr double margin = 0x1p-20;

    /// Computes the bounds of a packet, which must not be empty. Directions have usual lengths: see
    /// RescaledRay.
    explicit PacketBounds(const RayPacket& packet);

    /// Returns whether all rays go the same way along the dominant axis. If not, the bounds are of
    /// no use.
    bool goes_one_way() const { return goes_up_ || goes_down_; }

    /// Writes the numbers of the boxes that a ray may hit to `numbers`, which must have room for
    /// all boxes, and returns their count. All other boxes are outside the margin, which is far
    /// above all roundings. The rays must go one way.
    std::size_t find_near(const BoxColumns& boxes, std::uint32_t* numbers) const;

    struct Interval {
        double least, most;
    };

    /// Bounds of the rays' origins and slopes on each axis.
    struct Intervals {
        std::array<Interval, 3> origins;
        /// Direction divided by its component along the dominant axis; on that axis 1 / the
        /// component.
        std::array<Interval, 3> slopes;
    };

  private:
    int dominant_;
    Intervals all_;
    bool goes_up_, goes_down_;  ///< along the dominant axis
};

}  // namespace etalon
