#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/fresnel.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// Reflection by mirroring microfacets: Torrance and Sparrow 1967, "Theory for Off-Specular
/// Reflection from Roughened Surfaces".
struct MicrofacetReflection {
    static constexpr LobeKind kind = LobeKind::reflection;
    Color reflectance;
    TrowbridgeReitz facets;
    Fresnel fresnel;

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { reflectance *= by; }
};

}  // namespace etalon
