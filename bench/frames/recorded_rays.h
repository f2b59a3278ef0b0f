#pragma once

#include <vector>

#include "core/intersect/batch_intersector.h"

namespace etalon::frames {

/// Passes an integrator's queries on to a backend, and keeps every n-th batch of rays, so that the
/// backend can be measured alone on the same rays. For one thread.
class RecordedRays : public BatchIntersector {
  public:
    /// Keeps one batch in `every`, of both kinds of query. The backend must outlive this.
    RecordedRays(const BatchIntersector& backend, std::size_t every)
        : backend_(backend), every_(every) {}

    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void closest(const RayStream& rays, std::span<Hit> hits) const override;
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override;
    void occluded(const RayStream& rays, std::span<std::uint8_t> blocked) const override;

    /// Repeats the kept queries. Returns the seconds of processor time that all rays would have
    /// taken.
    double replay() const;

  private:
    /// A copy of the rays of a stream.
    class KeptStream {
      public:
        explicit KeptStream(const RayStream& rays);
        RayStream view() const;

      private:
        RayStream like_;  ///< its columns may be gone
        RayBuffer rays_;
        std::vector<ShutterTime> times_;
    };

    /// The batches of one kind of query.
    struct Batches {
        std::vector<std::vector<Ray>> kept;
        std::vector<KeptStream> kept_streams;
        std::size_t batches = 0, rays = 0, kept_rays = 0;

        void add(std::span<const Ray> more, std::size_t every);
        void add(const RayStream& more, std::size_t every);
        bool is_kept(std::size_t more, std::size_t every);
        /// Returns the seconds of all rays, if the kept ones took `seconds`.
        double of_all(double seconds) const;
    };

    const BatchIntersector& backend_;
    std::size_t every_;
    mutable Batches closest_, occluded_;
};

}  // namespace etalon::frames
