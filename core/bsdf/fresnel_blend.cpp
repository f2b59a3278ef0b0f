#include "core/bsdf/fresnel_blend.h"

namespace etalon {
namespace {

float fifth_power(float x) {
    return x * x * (x * x) * x;
}

/// Schlick's approximation of Fresnel's equations (1994).
Color schlick(const Color& from_above, float cos) {
    return from_above + fifth_power(1 - cos) * (Color(1) - from_above);
}

/// Returns the fraction of light at this angle that passes the coat.
float through_coat(const Vec3f& w) {
    return 1 - fifth_power(1 - std::abs(w.z) / 2);
}

/// Returns the albedo of the base alone: the model's 28/23 makes the integral over the other
/// direction 1.
Color diffuse_albedo(const FresnelBlend& lobe, const Vec3f& wo) {
    return lobe.diffuse * (Color(1) - lobe.glossy) * through_coat(wo);
}

Color glossy_albedo(const FresnelBlend& lobe, const Vec3f& wo) {
    return schlick(lobe.glossy, std::abs(wo.z));
}

/// Returns the fraction of samples for the base. It is below 1, as a coat is glossy at some angle.
float diffuse_probability(const FresnelBlend& lobe, const Vec3f& wo) {
    constexpr float most = 0.9F;
    const float diffuse = mean(diffuse_albedo(lobe, wo)), glossy = mean(glossy_albedo(lobe, wo));
    return diffuse > 0 ? std::min(most, diffuse / (diffuse + glossy)) : 0;
}

}  // namespace

Evaluation FresnelBlend::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const Vec3f sum = wo + wi;
    const float larger_cos = std::max(std::abs(wo.z), std::abs(wi.z));
    if (larger_cos == 0 || sum == Vec3f(0)) return {};
    const Vec3f m = normalized(sum);
    const float cos = wi.dot(m), density = facets.density(m);
    const Color base = (28 * inverse_pi / 23 * through_coat(wi)) * diffuse_albedo(*this, wo);
    const Color coat = (density / (4 * std::abs(cos) * larger_cos)) * schlick(glossy, cos);
    if (!same_side(wo, wi)) return {factor * (base + coat), 0};
    const float p = diffuse_probability(*this, wo);
    return {factor * (base + coat),
            p * std::abs(wi.z) * inverse_pi + (1 - p) * facets.reflected_density(wo, density)};
}

std::optional<Vec3f> FresnelBlend::sample(const Vec3f& wo, const Vec2& uv) const {
    const float p = diffuse_probability(*this, wo);
    if (uv.x < p) return cosine_direction(wo, {uv.x / p, uv.y});
    const Vec3f wi = facets.sample_reflected(wo, {(uv.x - p) / (1 - p), uv.y});
    return same_side(wo, wi) ? std::optional(wi) : std::nullopt;
}

Color FresnelBlend::albedo(const Vec3f& wo) const {
    return factor * (diffuse_albedo(*this, wo) + glossy_albedo(*this, wo));
}

}  // namespace etalon
