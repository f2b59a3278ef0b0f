#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// A diffuse base seen through a glossy coat: Ashikhmin and Shirley 2000, "An Anisotropic Phong
/// BRDF Model", with the facets of Trowbridge and Reitz.
struct FresnelBlend {
    static constexpr LobeKind kind = LobeKind::reflection;
    Color diffuse, glossy;  ///< glossy: reflectance of the coat at normal incidence
    TrowbridgeReitz facets;
    Color factor{1};  ///< factor of the whole lobe

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { factor *= by; }
};

}  // namespace etalon
