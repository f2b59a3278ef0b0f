#pragma once

#include <array>

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

    /// A way on, by mirror or through glass.
    struct Way {
        std::array<Vec3, most> origins, directions;
        std::array<double, most> outwards;  ///< normal . direction
    };

    /// What rays meet and what they do there, side by side.
    struct Chunk {
        std::size_t count;
        const Vec3 *directions, *positions, *errors, *normals, *shading_normals;
        const double* fronts;
        double bias;
        std::array<double, most> leave;  ///< 0 where no ray leaves, 1 from mirrors, 2 from glass
        std::array<double, most> etas;   ///< n_here / n_beyond

        std::array<double, most> cosines, reflectances, total;  ///< total: 1 or 0
        Way mirrored, refracted;
    };

    /// `surfaces` must outlive the rays, and have a material each.
    LeavingRays(const SeenSurfaces& surfaces, const LeavingRules& rules)
        : surfaces_(surfaces), rules_(rules) {}

    /// Makes the rays of the surfaces from number `first` on, at most `most`. Returns their number.
    std::size_t make(std::size_t first);

    /// The border at surface number first + i, where it is one of glass.
    double reflectance(std::size_t i) const { return chunk_.reflectances[i]; }
    bool is_total(std::size_t i) const { return chunk_.total[i] != 0; }

    /// Whether a ray through the surface runs behind it.
    bool enters(std::size_t i) const { return surfaces_.entering(first_ + i); }

    Ray mirrored(std::size_t i) const { return ray(i, chunk_.mirrored); }

    /// Nothing where the reflection is total.
    Ray refracted(std::size_t i) const { return ray(i, chunk_.refracted); }

  private:
    Ray ray(std::size_t i, const Way& way) const;
    void use_schlick();

    const SeenSurfaces& surfaces_;
    LeavingRules rules_;
    std::size_t first_ = 0;
    Chunk chunk_;
};

}  // namespace etalon
