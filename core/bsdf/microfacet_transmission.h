#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// Returns whether rays pass facets of the index straight, so that no direction tells the facet:
/// its normal is along wo + eta wi, which is then at most |eta - 1| long (times a factor that
/// facets at grazing angles have), while roundings of floats put 2^-23 into it, 1 % of 1e-5.
inline bool passes_straight(float eta) {
    return std::abs(eta - 1) < 1e-5F;
}

/// Refraction by microfacets between dielectrics: Walter et al. 2007, "Microfacet Models for
/// Refraction through Rough Surfaces". It transports radiance, which is divided by eta^2.
///
/// Value and density are those of PBRT version 3, which omits Walter's rule that microfacets facing
/// away from `wo` do not contribute. Such facets are never sampled, so that they show only in light
/// that is sampled at its source, with its MIS weight against this density, as in PBRT's images.
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
