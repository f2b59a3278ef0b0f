#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// Refraction by facets between dielectrics: Walter et al. 2007, "Microfacet Models for Refraction
/// through Rough Surfaces". Of radiance, which is divided by eta^2.
///
/// Value and density are those of PBRT version 3, which leaves out Walter's rule that a facet whose
/// back is turned to `wo` has no part. Such facets are never drawn, so that they show in light that
/// is sampled at its source only, and by its weight against this density; its pictures have that.
struct MicrofacetTransmission {
    static constexpr LobeKind kind = LobeKind::transmission;
    Color transmittance;
    TrowbridgeReitz facets;
    float eta;  ///< index below over index above

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { transmittance *= by; }
};

}  // namespace etalon
