#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/intersect/batch_intersector.h"
#include "core/intersect/packet_bounds.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An exact backend with packets for small scenes: packets of coherent rays are tested against the
/// few primitives that they may hit. All other rays go to the backend itself. Hits have the same
/// bits as the backend's.
class PacketIntersector final : public BatchIntersector {
  public:
    /// Largest number of primitives for which culling takes less time than the traversal of a tree
    /// by each ray.
    static constexpr std::size_t most_primitives = 256;

    /// `geometry` and `backend` must outlive the object. If the backend is not exact, all rays go
    /// to it.
    PacketIntersector(const Geometry& geometry, const BatchIntersector& backend, bool is_exact);

    /// Returns whether packets are used at all.
    bool has_packets() const { return has_packets_; }

    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void closest(const RayStream& rays, std::span<Hit> hits) const override;
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override;
    void occluded(const RayStream& rays, std::span<std::uint8_t> blocked) const override;

  private:
    /// Numbers of boxes.
    using Near = std::array<std::uint32_t, most_primitives>;

    std::optional<std::span<const std::uint32_t>> find_few(const RayPacket& packet,
                                                           Near& near) const;
    template <class Rays, class Answer, class Offer, class Ask>
    void answer_all(const Rays& rays, std::span<Answer> answers, const Offer& offer,
                    const Ask& ask) const;
    template <class Rays>
    void find_closest(const Rays& rays, std::span<Hit> hits) const;
    template <class Rays>
    void find_occluded(const Rays& rays, std::span<std::uint8_t> blocked) const;

    const Geometry& geometry_;
    const BatchIntersector& backend_;
    bool has_packets_;
    BoxColumns boxes_;                       ///< bounds of the primitives that can be hit
    std::vector<std::uint32_t> primitives_;  ///< number of the primitive in each box
    std::vector<std::uint8_t> costs_;        ///< cost of testing a packet against it
};

}  // namespace etalon
