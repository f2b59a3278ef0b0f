#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/intersect/box_columns.h"
#include "core/intersect/ray_packet.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Finds the primitives of a small scene that rays of a packet may hit.
class NearPrimitives {
  public:
    /// Largest number of primitives for which culling takes less time than the traversal of a tree
    /// by each ray.
    static constexpr std::size_t most = 256;

    /// Numbers of primitives; there is room for all.
    using Numbers = std::array<std::uint32_t, most>;

    NearPrimitives() = default;

    /// The geometry has at most `most` primitives.
    explicit NearPrimitives(const Geometry& geometry);

    /// Writes the numbers of the primitives that a ray may hit to `numbers`. Returns nothing if the
    /// packet has no useful bounds.
    std::optional<std::span<std::uint32_t>> find(const RayPacket& packet, Numbers& numbers) const;

    /// Returns whether to test all rays against these primitives takes less time than the traversal
    /// of a tree by each ray.
    bool are_few(std::span<const std::uint32_t> primitives, const RayPacket& packet) const;

  private:
    BoxColumns boxes_;                       ///< bounds of the primitives that can be hit
    std::vector<std::uint32_t> primitives_;  ///< number of the primitive in each box
    std::vector<std::uint8_t> costs_;        ///< cost of testing a packet against each primitive
};

}  // namespace etalon
