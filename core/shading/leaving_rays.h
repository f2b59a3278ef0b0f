#pragma once

#include <array>
#include <cstdint>

#include "core/shading/fresnel.h"
#include "core/shading/seen_surfaces.h"

namespace etalon {

/// Rules by which rays leave surfaces.
struct LeavingRules {
    bool schlick;       ///< see fresnel_schlick()
    double fixed_bias;  ///< if not 0: distance of the origins from the surface along its normal
};

/// The rays mirrored and refracted by surfaces, computed several at a time.
class LeavingRays {
  public:
    static constexpr std::size_t most = 64;

    /// A set of surfaces of a chunk: the lowest bit is the first surface.
    using Choice = std::uint64_t;

    /// Rays of one kind, mirrored or refracted, one for each surface of the chunk.
    struct SpawnedRays {
        Vec3Columns<most> origins, directions;
        std::array<double, most> excludes;
    };

    /// The rays that leave the surfaces from number `first` on.
    struct Chunk {
        std::size_t first, count;
        Choice leave;                   ///< surfaces that a ray leaves
        std::array<double, most> etas;  ///< indices of refraction, incident / other side

        std::array<double, most> cosines, reflectances, total;  ///< total: 1 or 0
        SpawnedRays mirrored, refracted;
    };

    /// `surfaces` must outlive the object; each must have a material.
    LeavingRays(const SeenSurfaces& surfaces, const LeavingRules& rules)
        : surfaces_(surfaces), rules_(rules) {}

    /// Computes the rays of the surfaces from number `first` on, at most `most` of them. Returns
    /// the number of surfaces.
    std::size_t make(std::size_t first);

    /// Returns the surfaces of the chunk that are mirrors or glass.
    Choice active() const { return chunk_.leave; }

    /// Fresnel reflectance, and whether reflection is total, at surface number first + i. Valid
    /// where it is glass.
    double reflectance(std::size_t i) const { return chunk_.reflectances[i]; }
    bool is_total(std::size_t i) const { return chunk_.total[i] != 0; }

    /// Returns whether the ray that hit surface number first + i came from in front of it.
    bool enters(std::size_t i) const { return surfaces_.entering(chunk_.first + i); }

    /// Writes the mirrored rays of the chosen surfaces to a buffer, which must have room for them,
    /// from number `at` on.
    void put_mirrored(Choice choice, RayBuffer& to, std::size_t at) const;

    /// The same for the refracted rays. A surface with total reflection must not be chosen.
    void put_refracted(Choice choice, RayBuffer& to, std::size_t at) const;

  private:
    void use_schlick();

    const SeenSurfaces& surfaces_;
    LeavingRules rules_;
    Chunk chunk_;
};

}  // namespace etalon
