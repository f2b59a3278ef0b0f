#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/intersect/batch_intersector.h"
#include "core/intersect/packet_bounds.h"
#include "core/scene/geometry.h"

namespace etalon {

/// What integrators ask of an exact backend: where a scene has few primitives, packets of
/// neighbouring rays that go nearly the same way are tested against the few that are next to them;
/// all else goes to the backend itself. Hits are to the bit those of the backend.
class PacketIntersector final : public BatchIntersector {
  public:
    /// So many primitives are looked at in less time than the way of each ray through a tree takes.
    static constexpr std::size_t most_primitives = 256;

    /// Geometry and backend must outlive this. All is for a backend that is not exact itself.
    PacketIntersector(const Geometry& geometry, const BatchIntersector& backend, bool is_exact);

    /// Whether there are packets at all.
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
    BoxColumns boxes_;                       ///< of the primitives that can be hit
    std::vector<std::uint32_t> primitives_;  ///< numbers of these
    std::vector<std::uint8_t> costs_;        ///< of testing a packet against them
};

}  // namespace etalon
