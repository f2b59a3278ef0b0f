#pragma once

#include "core/intersect/batch_intersector.h"
#include "core/intersect/near_primitives.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An exact backend with packets for small scenes: packets of coherent rays are tested against the
/// few primitives that they may hit. All other rays go to the backend itself. Hits have the same
/// bits as the backend's.
class PacketIntersector final : public BatchIntersector {
  public:
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
    class Closest;
    class Occluded;

    template <class Rays, class Answer, class Query>
    void answer_all(const Rays& rays, std::span<Answer> answers, Query query) const;
    template <class Rays>
    void find_closest(const Rays& rays, std::span<Hit> hits) const;
    template <class Rays>
    void find_occluded(const Rays& rays, std::span<std::uint8_t> blocked) const;

    const Geometry& geometry_;
    const BatchIntersector& backend_;
    bool has_packets_;
    NearPrimitives near_;
};

}  // namespace etalon
