#include "core/bsdf/oren_nayar.h"

namespace etalon {

OrenNayarReflection::OrenNayarReflection(const Color& reflectance, float sigma)
    : reflectance_(reflectance) {
    const float radians = sigma * std::numbers::pi_v<float> / 180, sigma2 = radians * radians;
    a_ = 1 - sigma2 / (2 * (sigma2 + 0.33F));
    b_ = 0.45F * sigma2 / (sigma2 + 0.09F);
}

Evaluation OrenNayarReflection::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    // max(0, cos(difference in phi)) sin(alpha) tan(beta), alpha the larger of the two angles to
    // the normal. Its sines cancel those of the difference's cosine, so that one division is left.
    const float across = std::max(0.0F, wo.x * wi.x + wo.y * wi.y);
    const float cos_beta = std::max(std::abs(wi.z), std::abs(wo.z));
    return {reflectance_ * ((a_ + b_ * across / cos_beta) * inverse_pi),
            std::abs(wi.z) * inverse_pi};
}

}  // namespace etalon
