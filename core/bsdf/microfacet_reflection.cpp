#include "core/bsdf/microfacet_reflection.h"

#include "core/bsdf/rough_fresnel.h"

namespace etalon {

Evaluation MicrofacetReflection::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const Vec3f sum = wo + wi;
    if (wo.z == 0 || wi.z == 0 || sum == Vec3f(0)) return {};
    const Vec3f m = normalized(sum);
    const float density = facets.density(m);
    // The side of the incident light, on which the indices depend, is that of wi beside the upper
    // m.
    const Color fresnel_term = etalon::reflectance(fresnel, std::copysign(1.0F, m.z) * wi.dot(m));
    return {reflectance * fresnel_term * (density * facets.visibility(wo, wi)),
            same_side(wo, wi) ? facets.reflected_density(wo, density) : 0};
}

std::optional<Vec3f> MicrofacetReflection::sample(const Vec3f& wo, const Vec2& uv) const {
    const Vec3f wi = facets.sample_reflected(wo, uv);
    return same_side(wo, wi) ? std::optional(wi) : std::nullopt;
}

Color MicrofacetReflection::albedo(const Vec3f& wo) const {
    // Light between facets is lost; fitted by eye to integrals for white facets.
    const float alpha = facets.mean_alpha();
    const float kept = 1 / (1 + 2 * alpha * alpha * std::abs(wo.z));
    return reflectance * (kept * mean_reflectance(fresnel, facets, wo));
}

}  // namespace etalon
