#pragma once

#include <array>
#include <cstdint>

#include "core/shading/fresnel.h"
#include "core/shading/seen_surfaces.h"

namespace etalon {

/// How rays leave surfaces.
struct LeavingRules {
    bool schlick;       ///< see fresnel_schlick()
    double fixed_bias;  ///< other than 0: how far from the surface along its normal they start
};

/// The rays that mirrors and glass send on from surfaces, made several at a time.
class LeavingRays {
  public:
    static constexpr std::size_t most = 64;

    /// Some surfaces of a chunk, a bit for each, from the lowest on.
    using Choice = std::uint64_t;

    /// A way on, by mirror or through glass.
    struct Way {
        Vec3Columns<most> origins, directions;
        std::array<double, most> excludes;
    };

    /// What rays do at surfaces from number `first` on.
    struct Chunk {
        std::size_t first, count;
        Choice leave;                   ///< where a ray leaves
        std::array<double, most> etas;  ///< n_here / n_beyond, there

        std::array<double, most> cosines, reflectances, total;  ///< total: 1 or 0
        Way mirrored, refracted;
    };

    /// `surfaces` must outlive the rays, and have a material each.
    LeavingRays(const SeenSurfaces& surfaces, const LeavingRules& rules)
        : surfaces_(surfaces), rules_(rules) {}

    /// Makes the rays of the surfaces from number `first` on, at most `most`. Returns their number.
    std::size_t make(std::size_t first);

    /// The surfaces of the chunk that send rays on.
    Choice senders() const { return chunk_.leave; }

    /// The border at surface number first + i, where it is one of glass.
    double reflectance(std::size_t i) const { return chunk_.reflectances[i]; }
    bool is_total(std::size_t i) const { return chunk_.total[i] != 0; }

    /// Whether a ray through the surface runs behind it.
    bool enters(std::size_t i) const { return surfaces_.entering(chunk_.first + i); }

    /// Writes the chosen rays to a buffer, from number `at` on, which has room for them.
    void put_mirrored(Choice choice, RayBuffer& to, std::size_t at) const;

    /// The same of the others. Nothing is to be chosen where the reflection is total.
    void put_refracted(Choice choice, RayBuffer& to, std::size_t at) const;

  private:
    void use_schlick();

    const SeenSurfaces& surfaces_;
    LeavingRules rules_;
    Chunk chunk_;
};

}  // namespace etalon
