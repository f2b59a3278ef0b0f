#pragma once

#include "core/intersect/normalized_space.h"
#include "core/intersect/ray_columns.h"

namespace etalon {

/// RayQuery and NormalizedSpace applied to a batch of rays, several at a time in SIMD lanes. The
/// bits are those that each ray has alone.
class LocalRays {
  public:
    static constexpr std::size_t most = RayColumns::most;

    /// Kind of a ray, which determines how it is answered.
    enum class Kind : std::uint64_t {
        slow_path = 0,  ///< rare: not is_valid(), not resolves(), or with extreme numbers
        misses,         ///< misses everything that is bounded
        enters,
    };

    /// Classifies rays.
    void set(const NormalizedSpace& space, const RayColumns& rays);

    Kind kind(std::size_t i) const { return static_cast<Kind>(kinds_[i]); }

    /// Returns the dominant axis of a ray's direction.
    int dominant(std::size_t i) const { return static_cast<int>(dominants_[i]); }

    /// Returns a ray of Kind::enters in normalized space.
    NormalizedRay ray(std::size_t i) const {
        return {origins_[i], directions_[i], shifts_[i], scales_[i]};
    }

  private:
    std::array<Vec3f, most> origins_, directions_;
    std::array<double, most> shifts_, scales_;
    std::array<std::uint64_t, most> kinds_, dominants_;
};

/// Output columns of LocalRays.
struct LocalRayColumns {
    Vec3f *origins, *directions;
    double *shifts, *scales;
    std::uint64_t* kinds;
};

}  // namespace etalon
