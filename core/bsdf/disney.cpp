#include "core/bsdf/disney.h"

#include "core/bsdf/microfacet_reflection.h"
#include "core/bsdf/microfacet_transmission.h"

namespace etalon {
namespace {

/// Returns the cosine of the angle of either direction to the half vector; none if they are
/// opposite.
std::optional<float> cosine_to_half(const Vec3f& wo, const Vec3f& wi) {
    const Vec3f sum = wo + wi;
    if (sum == Vec3f(0)) return {};
    return wi.dot(normalized(sum));
}

/// Hanrahan and Krueger 1993, as Burley flattens the retroreflection.
float flat_value(float from_o, float from_i, float cosines, float f90) {
    const float f = (1 + (f90 - 1) * from_o) * (1 + (f90 - 1) * from_i);
    return 1.25F * (f * (1 / cosines - 0.5F) + 0.5F);
}

/// Returns the fraction of facets visible from two directions with independent masking, over that
/// with correlated masking.
float independent_masking(const TrowbridgeReitz& facets, const Vec3f& wo, const Vec3f& wi) {
    const float both = 4 * facets.visibility(wo, wi);
    return both > 0 ? facets.visible_scale(wo) * facets.visible_scale(wi) / both : 0;
}

MicrofacetReflection reflection_of(const DisneyGloss& g) {
    return {g.factor, g.facets, g.fresnel};
}

MicrofacetTransmission transmission_of(const DisneyTransmission& t) {
    return {t.transmittance, t.facets, t.eta};
}

}  // namespace

Evaluation DisneyBase::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const float cos_o = std::abs(wo.z), cos_i = std::abs(wi.z), pdf = cos_i * inverse_pi;
    const float from_o = schlick_weight(cos_o), from_i = schlick_weight(cos_i);
    float sum = diffuse * (1 - from_o / 2) * (1 - from_i / 2);
    const std::optional<float> cos = cosine_to_half(wo, wi);
    if (!cos || cos_o + cos_i == 0) return {color * (inverse_pi * sum), pdf};
    const float f90 = *cos * *cos * roughness, back = 2 * f90;
    if (flat > 0) sum += flat * flat_value(from_o, from_i, cos_o + cos_i, f90);
    sum += retro * back * (from_o + from_i + from_o * from_i * (back - 1));
    return {color * (inverse_pi * sum) + schlick_weight(*cos) * sheen, pdf};
}

Color DisneyBase::albedo(const Vec3f& wo) const {
    // Fitted by eye to integrals.
    const float from_o = schlick_weight(std::abs(wo.z));
    const float part = diffuse * (1 - from_o / 2) + flat + retro * roughness * (0.1F + from_o);
    return part * color + (0.02F + 0.3F * from_o) * sheen;
}

Evaluation DisneyGloss::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    Evaluation e = reflection_of(*this).evaluate(wo, wi);
    if (!is_black(e.f)) e.f *= independent_masking(facets, wo, wi);
    return e;
}

std::optional<Vec3f> DisneyGloss::sample(const Vec3f& wo, const Vec2& uv) const {
    return reflection_of(*this).sample(wo, uv);
}

Color DisneyGloss::albedo(const Vec3f& wo) const {
    return reflection_of(*this).albedo(wo);
}

Evaluation DisneyTransmission::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    Evaluation e = transmission_of(*this).evaluate(wo, wi);
    if (!is_black(e.f)) e.f *= independent_masking(facets, wo, wi);
    return e;
}

std::optional<Vec3f> DisneyTransmission::sample(const Vec3f& wo, const Vec2& uv) const {
    return transmission_of(*this).sample(wo, uv);
}

Color DisneyTransmission::albedo(const Vec3f& wo) const {
    return transmission_of(*this).albedo(wo);
}

DisneyClearcoat::DisneyClearcoat(float weight, float gloss) : factor_(weight) {
    constexpr float roughest = 0.1F, smoothest = 0.001F;
    const float alpha = roughest + std::clamp(gloss, 0.0F, 1.0F) * (smoothest - roughest);
    alpha2_ = alpha * alpha;
}

/// Returns Burley's GTR1, per solid angle of the facets' normals over the surface's area.
float DisneyClearcoat::density(const Vec3f& m) const {
    const float spread = sine_squared(m) + alpha2_ * m.z * m.z;
    return (alpha2_ - 1) * inverse_pi / (std::log(alpha2_) * spread);
}

Evaluation DisneyClearcoat::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const Vec3f sum = wo + wi;
    if (sum == Vec3f(0)) return {};
    const Vec3f m = normalized(sum);
    const float d = density(m), cos = wo.dot(m), w = schlick_weight(cos);
    const auto seen = [](float z) {  // Smith's masking for a roughness that is always 0.25
        constexpr float alpha2 = 0.0625F;
        return 1 / (std::abs(z) + std::sqrt(alpha2 + (1 - alpha2) * z * z));
    };
    constexpr float from_above = 0.04F;  // an index of 1.5
    const float fresnel = from_above + (1 - from_above) * w;
    const float value = seen(wo.z) * seen(wi.z) * fresnel * d / 4;
    return {factor_ * value, same_side(wo, wi) ? d * std::abs(m.z) / (4 * cos) : 0};
}

std::optional<Vec3f> DisneyClearcoat::sample(const Vec3f& wo, const Vec2& uv) const {
    const double a = alpha2_, angle = 2 * std::numbers::pi * uv.y;
    const double sine2 = std::clamp((std::pow(a, 1 - uv.x) - a) / (1 - a), 0.0, 1.0);
    const double sine = std::sqrt(sine2), cosine = std::sqrt(1 - sine2);
    const Vec3f m(
        Vec3(sine * std::cos(angle), sine * std::sin(angle), std::copysign(cosine, double(wo.z))));
    const Vec3f wi = 2 * wo.dot(m) * m - wo;
    return same_side(wo, wi) ? std::optional(wi) : std::nullopt;
}

Color DisneyClearcoat::albedo(const Vec3f& wo) const {
    return factor_ * (0.25F * (0.04F + 0.96F * schlick_weight(std::abs(wo.z))));
}

}  // namespace etalon
