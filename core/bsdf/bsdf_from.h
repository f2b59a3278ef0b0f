#pragma once

#include <array>
#include <optional>

#include "core/bsdf/bsdf_frame.h"
#include "core/bsdf/lobe_list.h"

namespace etalon {

/// A direction sampled for `wo`. A path's throughput is multiplied by f |wi.ns| / pdf.
struct BsdfSample {
    Vec3 wi;  ///< unit
    Color f;
    float pdf;          ///< per solid angle; for a specular lobe the probability of the choice
    bool specular;      ///< only this direction has a part in it, and `evaluate` ignores it
    bool transmission;  ///< through the surface
    bool only_lights;   ///< pbrt-v3 samples lights in this direction, but no paths go there
    float eta;  ///< index on the side of `wi` over that on the side of `wo`; 1 for a reflection
};

/// Scattering at one point for one direction `wo`, to the eye; what depends only on `wo` is
/// computed once. All directions are unit vectors of the world that point away from the surface;
/// cosines are to the shading normal. Frame and lobes must outlive it.
class BsdfFrom {
  public:
    BsdfFrom(const BsdfFrame& frame, const LobeList& lobes, const Vec3& wo);

    /// Returns value and density of the smooth lobes.
    Evaluation evaluate(const Vec3& wi) const;

    /// Returns whether `wi` is on the other side of the surface.
    bool passes(const Vec3& wi) const { return side(wi) == LobeKind::transmission; }

    /// Returns whether `wi` is on the same side of the surface as `wo` by both normals.
    bool reflects(const Vec3& wi) const { return !passes(wi) && frame_.ns.dot(wi) * wo_.z > 0; }

    /// Samples a lobe by `lobe_choice` and a direction of it by `uv`, all in [0, 1). Nothing if the
    /// choice carries no light.
    std::optional<BsdfSample> sample(float lobe_choice, const Vec2& uv) const;

    /// Returns an estimate of the fraction of the light from `wo` that is scattered.
    Color albedo() const;

  private:
    std::size_t chosen(float choice) const;
    LobeKind side(const Vec3& wi) const;
    Evaluation evaluate_local(const Vec3f& wi, LobeKind side) const;
    float turned_density(const Vec3f& wi, LobeKind side) const;
    bool is_sampled_unturned(const Vec3f& wi) const;
    std::optional<BsdfSample> sample_smooth(Vec3f local_wi, std::optional<LobeKind> own_side) const;
    std::optional<BsdfSample> sample_specular(float pick,
                                              const std::optional<SpecularSample>& chosen) const;

    const BsdfFrame& frame_;
    const LobeList& lobes_;
    Vec3 exact_wo_;                                ///< local
    Vec3f wo_;                                     ///< local
    double above_;                                 ///< wo.ng
    std::array<float, LobeList::capacity> picks_;  ///< probabilities of choosing each lobe
};

}  // namespace etalon
