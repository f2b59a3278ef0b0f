#pragma once

#include "core/intersect/normalized_space.h"
#include "core/intersect/ray_columns.h"

namespace etalon {

/// What RayQuery and NormalizedSpace make of some rays, found for several of them at a time: to the
/// bits that each has alone.
class LocalRays {
  public:
    static constexpr std::size_t most = RayColumns::most;

    /// What to do with a ray.
    enum class Way : std::uint64_t {
        by_itself = 0,  ///< what is seldom: see is_valid(), resolves(), and numbers of extreme size
        passes_by,      ///< meets nothing of what is bounded
        enters,
    };

    /// Looks at up to `most` rays.
    void set(const NormalizedSpace& space, std::span<const Ray> rays);

    Way way(std::size_t i) const { return static_cast<Way>(ways_[i]); }

    /// The dominant axis of a ray's direction.
    int dominant(std::size_t i) const { return static_cast<int>(dominants_[i]); }

    /// A ray that enters, in normalized space.
    NormalizedRay ray(std::size_t i) const {
        return {origins_[i], directions_[i], shifts_[i], scales_[i]};
    }

  private:
    std::array<Vec3f, most> origins_, directions_;
    std::array<double, most> shifts_, scales_;
    std::array<std::uint64_t, most> ways_, dominants_;
};

/// Where the columns of LocalRays are written.
struct LocalRayColumns {
    Vec3f *origins, *directions;
    double *shifts, *scales;
    std::uint64_t* ways;
};

}  // namespace etalon
