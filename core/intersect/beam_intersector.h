#pragma once

#include <vector>

#include "core/intersect/batch_intersector.h"
#include "core/intersect/ray_beam.h"
#include "core/scene/geometry.h"

namespace etalon {

/// What integrators ask of an exact backend: where a scene has few primitives, neighbouring rays
/// that go nearly the same way are taken together, as a beam, to the few next to it; all else goes
/// to the backend itself. Hits are to the bit those of the backend.
class BeamIntersector final : public BatchIntersector {
  public:
    /// So many primitives are looked at in less time than the way of each ray through a tree takes.
    static constexpr std::size_t most_primitives = 256;

    /// Geometry and backend must outlive this. All is for a backend that is not exact itself.
    BeamIntersector(const Geometry& geometry, const BatchIntersector& backend, bool is_exact);

    /// Whether rays are taken together at all.
    bool has_beams() const { return has_beams_; }

    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override;

  private:
    template <class Offer, class AskBackend>
    void for_each_beam(std::span<const Ray> rays, const Offer& offer,
                       const AskBackend& ask_backend) const;

    const Geometry& geometry_;
    const BatchIntersector& backend_;
    bool has_beams_;
    BoxColumns boxes_;                       ///< of the primitives that can be hit
    std::vector<std::uint32_t> primitives_;  ///< numbers of these
};

}  // namespace etalon
