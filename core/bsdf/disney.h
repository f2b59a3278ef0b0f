// Lobes of the material of Burley 2012, "Physically-Based Shading at Disney", and 2015, "Extending
// the Disney BRDF to a BSDF with Integrated Subsurface Scattering".
#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/fresnel.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// The diffuse base: four formulas, each of which pbrt-v3 has as a lobe.
struct DisneyBase {
    static constexpr LobeKind kind = LobeKind::reflection;
    Color color;
    float roughness;
    float diffuse;  ///< diffuse fraction of the colour
    float flat;     ///< fraction scattered below the surface, by Hanrahan and Krueger's law
    float retro;    ///< retroreflective fraction
    Color sheen;

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const {
        return cosine_direction(wo, uv);
    }
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) {
        color *= by;
        sheen *= by;
    }
};

/// Mirroring microfacets that are masked from the eye and from the light independently.
struct DisneyGloss {
    static constexpr LobeKind kind = LobeKind::reflection;
    Color factor;
    TrowbridgeReitz facets;
    DisneyFresnel fresnel;

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { factor *= by; }
};

/// Refracting microfacets, masked likewise.
struct DisneyTransmission {
    static constexpr LobeKind kind = LobeKind::transmission;
    Color transmittance;
    TrowbridgeReitz facets;
    float eta;  ///< index below over index above

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { transmittance *= by; }
};

/// A second gloss, whose microfacet distribution has longer tails.
class DisneyClearcoat {
  public:
    static constexpr LobeKind kind = LobeKind::reflection;

    /// `weight` of the coat, and its gloss from 0 to 1.
    DisneyClearcoat(float weight, float gloss);

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { factor_ *= by; }

  private:
    float density(const Vec3f& m) const;

    Color factor_;
    float alpha2_;  ///< square of the roughness
};

}  // namespace etalon
