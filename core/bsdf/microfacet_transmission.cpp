#include "core/bsdf/microfacet_transmission.h"

#include "core/bsdf/rough_fresnel.h"

namespace etalon {

Evaluation MicrofacetTransmission::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    if (same_side(wo, wi) || wo.z == 0 || wi.z == 0) return {};
    const float beyond = wo.z > 0 ? eta : 1 / eta;
    const Vec3f sum = wo + beyond * wi;
    if (sum == Vec3f(0)) return {};
    const Vec3f m = (sum.z < 0 ? -1.0F : 1.0F) * normalized(sum);
    const float cos_o = wo.dot(m), cos_i = wi.dot(m);
    if (cos_o * cos_i > 0) return {};

    const float path = cos_o + beyond * cos_i;
    const float facets_per_direction = facets.density(m) * std::abs(cos_o * cos_i) / (path * path);
    const float value = (1 - dielectric_reflectance(cos_o, eta)) * facets_per_direction * 4 *
                        facets.visibility(wo, wi);
    return {transmittance * value,
            facets_per_direction * beyond * beyond * facets.visible_scale(wo)};
}

std::optional<Vec3f> MicrofacetTransmission::sample(const Vec3f& wo, const Vec2& uv) const {
    const float beyond = wo.z > 0 ? eta : 1 / eta;
    const Vec3f m = facets.sample_visible(wo, uv);
    const float cos_o = wo.dot(m);
    const float sine_squared = (1 - cos_o * cos_o) / (beyond * beyond);
    if (sine_squared >= 1) return {};
    const Vec3f wi = (cos_o / beyond - std::sqrt(1 - sine_squared)) * m - wo / beyond;
    return same_side(wo, wi) ? std::nullopt : std::optional(normalized(wi));
}

Color MicrofacetTransmission::albedo(const Vec3f& wo) const {
    constexpr float least = 0.05F;  // some facets let light through wherever others reflect totally
    return transmittance *
           std::max(least, 1 - mean_reflectance(DielectricFresnel{eta}, facets, wo).x);
}

}  // namespace etalon
